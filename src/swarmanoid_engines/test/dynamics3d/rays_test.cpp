// Rays hit the shapes at their poses.
#include <gtest/gtest.h>

#include "swarmanoid_space/rays/solid_ray.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

TEST(RaysTest, TheNearestSurfaceIsHit) {
  World world;
  const Row prey = world.addPrey(0.1, 0.2, 0.3, 2.0, 2.0);
  const Row block = world.addBlock({0.2, 0.2, 0.2}, 1.0, flatPose(2.5, 2.0, 0.0, 0.1));
  const RayHit hit = world.castRay({1.0, 2.0, 0.1}, {3.0, 2.0, 0.1});
  EXPECT_EQ(hit.row, prey);
  EXPECT_NEAR(hit.fraction, 0.45, 1e-12);
  const RayHit behind = world.castRay({1.0, 2.0, 0.1}, {3.0, 2.0, 0.1}, prey);
  EXPECT_EQ(behind.row, block);
  EXPECT_NEAR(behind.fraction, 0.7, 1e-12);
  EXPECT_EQ(world.castRay({1.0, 2.0, 0.3}, {3.0, 2.0, 0.3}).row, kNoRow);  // above them
}

TEST(RaysTest, WhatLiesIsHitAsItLies) {
  World world;
  const Eigen::Quaterniond lying(Eigen::AngleAxisd(M_PI / 2.0, Vector3d::UnitY()));  // body z along x
  const Row prey = world.add(cylindricPreyModel(0.1, 0.4), {{2.0, 2.0, 0.1}, lying});
  const RayHit along = world.castRay({1.0, 2.0, 0.1}, {3.0, 2.0, 0.1});
  EXPECT_EQ(along.row, prey);
  EXPECT_NEAR(along.fraction, 0.5, 1e-12);
  const RayHit down = world.castRay({2.3, 2.0, 1.1}, {2.3, 2.0, 0.1});
  EXPECT_NEAR(down.fraction, 0.9, 1e-12);
}

TEST(RaysTest, BetweenEqualDistancesTheOlderIsHit) {
  World world;
  const Row older = world.addBlock({0.25, 0.25, 0.25}, 0.0, flatPose(2.0, 2.125, 0.0, 0.125));
  world.addBlock({0.25, 0.25, 0.25}, 0.0, flatPose(2.0, 1.875, 0.0, 0.125));
  EXPECT_EQ(world.castRay({1.0, 2.0, 0.1}, {3.0, 2.0, 0.1}).row, older);
  World reverse;
  const Row first = reverse.addBlock({0.25, 0.25, 0.25}, 0.0, flatPose(2.0, 1.875, 0.0, 0.125));
  reverse.addBlock({0.25, 0.25, 0.25}, 0.0, flatPose(2.0, 2.125, 0.0, 0.125));
  EXPECT_EQ(reverse.castRay({1.0, 2.0, 0.1}, {3.0, 2.0, 0.1}).row, first);
}

TEST(RaysTest, AMirrorIsHitInTheEngineThatMovesIt) {
  World world;
  World mover;
  const Row mirror = world.add(cylindricPreyModel(0.1, 0.2), flatPose(2.0, 2.0), Role::kMirror);
  EXPECT_EQ(world.castRay({1.0, 2.0, 0.1}, {3.0, 2.0, 0.1}).row, mirror);  // no engine moves it
  world.space.mover[mirror] = &mover.engine;
  world.step();
  EXPECT_EQ(world.castRay({1.0, 2.0, 0.1}, {3.0, 2.0, 0.1}).row, kNoRow);
}

TEST(RaysTest, LookingOnlyAtWhatIsNearLosesNothing) {
  // against a test of every entity
  World world;
  std::srand(5);
  const auto random = [] { return std::rand() / (RAND_MAX + 1.0); };
  for (int i = 0; i < 60; ++i) {
    const Pose pose{{4.0 * random(), 4.0 * random(), 0.5 + random()},
                    Eigen::Quaterniond(random(), random(), random(), random()).normalized()};
    world.add(i % 7 == 0 ? blockModel({2.0 * random(), 0.1, 0.3}, 0.0) : cylindricPreyModel(0.1, 0.1 + 0.3 * random()),
              pose, i % 2 == 0 ? Role::kMove : Role::kMirror);
  }
  world.step(3);
  int hit_count = 0;
  for (int i = 0; i < 500; ++i) {
    const Segment segment{{4.0 * random(), 4.0 * random(), random()}, {4.0 * random(), 4.0 * random(), random()}};
    RayHit expected;
    for (const Row row : world.space.entities.order) {
      const double fraction = closestHit(segment, *world.space.entities.model[row], world.space.entities.pose[row]);
      if (fraction < expected.fraction) {
        expected = {fraction, row};
      }
    }
    const RayHit hit = world.space.castRay(segment);
    ASSERT_EQ(hit.row, expected.row);
    ASSERT_EQ(hit.fraction, expected.fraction);
    hit_count += hit.row != kNoRow ? 1 : 0;
  }
  EXPECT_GT(hit_count, 100);
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
