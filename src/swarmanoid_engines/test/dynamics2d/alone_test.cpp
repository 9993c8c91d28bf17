// Bodies that nothing can reach move alone, and in the same way as in an island.
#include <gtest/gtest.h>

#include <vector>

#include "../exact_overlap.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector3d;

TEST(AloneTest, ABodyFarFromAllIsInNoIsland) {
  World world({10.0, 10.0, 2.0}, 4);
  const Row row = world.addFootbot(flatPose(1.0, 1.0));
  world.addFootbot(flatPose(8.0, 8.0));
  world.addPrey(0.1, 0.12, 8.0, 3.0);
  world.addBlock({0.1, 4.0, 0.5}, {2.0, 1.0, 0.25});
  world.drive(row, 0.1);
  world.step(2);
  EXPECT_EQ(world.engine.bodiesInIslands(), 0U);
  world.step(90);
  EXPECT_EQ(world.engine.bodiesInIslands(), 1U) << "at the wall";
  world.drive(row, -0.1);
  world.step(20);
  EXPECT_EQ(world.engine.bodiesInIslands(), 0U) << "away from it";
}

TEST(AloneTest, TheWayIsTheSameInAnIslandAndAlone) {
  // between two walls, which it does not touch, and far from all other bodies
  std::vector<Pose> ends;
  for (const bool near_wall : {true, false}) {
    World world({20.0, 20.0, 2.0}, 4);
    const Row row = world.addFootbot(flatPose(2.0, 2.0, 0.01));
    if (near_wall) {
      world.addBlock({8.0, 0.1, 0.5}, {4.0, 1.8, 0.25});
      world.addBlock({8.0, 0.1, 0.5}, {4.0, 2.2, 0.25});
    }
    for (int i = 0; i < 30; ++i) {
      world.drive(row, i % 6 < 3 ? 0.2 : -0.2, i % 10 < 5 ? -0.3 : 0.4);  // more than treels can follow in a step
      world.step();
      ASSERT_EQ(world.engine.bodiesInIslands(), near_wall ? 1U : 0U);
    }
    ends.push_back(world.pose(row));
  }
  EXPECT_LT((ends[0].position - ends[1].position).norm(), 2e-6);
  EXPECT_NEAR(headingOf(ends[0]), headingOf(ends[1]), 1e-5);
}

TEST(AloneTest, WhoComesFastIsMet) {
  // a robot that stands alone, and a robot that arrives from far away within few ticks
  World world({10.0, 10.0, 2.0}, 1);
  const Row standing = world.addFootbot(flatPose(6.0, 2.0));
  const Row comes = world.addRobot(discModel(0.1, 0.15), flatPose(1.0, 2.0));
  world.drive(comes, 4.0);
  for (int i = 0; i < 20; ++i) {
    world.step();
    ASSERT_LE(overlapOf(world.space, standing, comes), 0.6e-3);
    ASSERT_LT(world.pose(comes).position.x(), world.pose(standing).position.x());
  }
  EXPECT_GT(world.pose(standing).position.x(), 6.01) << "pushed along";
}

TEST(AloneTest, AMirrorThatIsPutBesideItIsFelt) {
  World world({10.0, 10.0, 2.0}, 4);
  const Row prey = world.addPrey(0.1, 0.12, 2.0, 2.0);
  const Row mirror = world.add(cylindricPreyModel(0.1, 0.1), flatPose(8.0, 2.0), Role::kMirror);
  world.step(5);
  EXPECT_EQ(world.engine.bodiesInIslands(), 0U);
  world.pose(mirror).position.x() = 1.85;  // placed into the prey at once
  world.step(30);
  EXPECT_GT((world.pose(prey).position - world.pose(mirror).position).norm(), 0.2 - 0.6e-3);
}

TEST(AloneTest, AFastBodyHasOnlyThoseInItsIslandThatItReaches) {
  World world({30.0, 10.0, 4.0}, 1);
  for (int i = 0; i < 10; ++i) {
    world.addFootbot(flatPose(1.0 + 2.0 * i, 1.0));
  }
  const Row eyebot = world.addToSpace(robotModel("eyebot"), flatPose(1.0, 4.0));
  world.space.actuation.bank<EyebotVelocity>().add(eyebot);
  test::carryOut(world.space);
  world.engine.add(world.space, eyebot, Role::kMove);
  world.space.actuation.bank<EyebotVelocity>().find(eyebot)->linear = {3.0, 0.0, 0.0};
  const Row standing = world.add(cylindricPreyModel(0.1, 1.0), flatPose(15.0, 4.0));
  std::size_t most = 0;
  for (int i = 0; i < 50; ++i) {
    world.step();
    most = std::max(most, world.engine.bodiesInIslands());
    ASSERT_LE(overlapOf(world.space, eyebot, standing), 0.6e-3);
  }
  EXPECT_EQ(most, 2U) << "the eyebot and what it runs into";
  EXPECT_GT(world.pose(standing).position.x(), 15.1);
}

TEST(AloneTest, WhatAFastOneHitsHitsOthers) {
  // a ball on ice, and more of them in a line, each too far from the next to be reached by slow bodies
  World world({20.0, 10.0, 2.0}, 1, "z", 0.0, {{"ground_friction", "0"}, {"restitution", "1"}});
  std::vector<Row> rows;
  for (const double x : {6.0, 6.35, 6.7, 7.05}) {
    rows.push_back(world.addPrey(0.1, 0.12, x, 2.0));
  }
  const Row fast = world.addToSpace(cylindricPreyModel(0.1, 0.12), flatPose(1.03, 2.0));
  world.space.entities.twist[fast].linear = {4.0, 0.0, 0.0};
  test::carryOut(world.space);
  world.engine.add(world.space, fast, Role::kMove);
  rows.insert(rows.begin(), fast);
  for (int i = 0; i < 20; ++i) {
    world.step();
    ASSERT_LE(deepestOverlap(world.space, rows), 0.6e-3) << i;
    for (std::size_t k = 1; k < rows.size(); ++k) {
      ASSERT_LT(world.pose(rows[k - 1]).position.x(), world.pose(rows[k]).position.x()) << i;
    }
  }
  EXPECT_NEAR(world.twist(rows.back()).linear.x(), 4.0, 1e-3) << "handed on from ball to ball";
}

TEST(AloneTest, WhatIsAddedOrPlacedNearbyIsFelt) {
  World world({10.0, 10.0, 2.0}, 4);
  const Row row = world.addFootbot(flatPose(1.0, 1.0));
  const Row prey = world.addPrey(0.1, 0.12, 8.0, 8.0);
  world.drive(row, 0.1);
  world.step(10);
  world.pose(prey).position = {1.0 + 0.1 + 0.11 + 0.1 + 0.005, 1.0, 0.0};
  world.engine.place(world.space, prey);
  world.step(10);
  EXPECT_NEAR(world.pose(prey).position.x() - world.pose(row).position.x(), 0.21, 0.2e-3);
  const Row wall = world.addBlock({0.1, 4.0, 0.5}, {world.pose(prey).position.x() + 0.1 + 0.02 + 0.05, 1.0, 0.25});
  world.step(20);
  EXPECT_LE(overlapOf(world.space, wall, prey), 0.6e-3);
}

TEST(AloneTest, AGripTakesHoldOfWhoWasAlone) {
  World world({10.0, 10.0, 2.0}, 4);
  const Row row = world.addFootbot(flatPose(1.0, 1.0));
  const Row prey = world.addPrey(0.1, 0.12, 1.0 + 0.11 + 0.1 + 0.015, 1.0);
  world.step(5);
  EXPECT_EQ(world.engine.bodiesInIslands(), 0U) << "both at rest, and not touching";
  world.setGripper(row, true);
  world.step();
  ASSERT_EQ(world.space.structure.grippedBy(row), prey);
  world.drive(row, -0.1);
  world.step(20);
  EXPECT_NEAR((world.pose(prey).position - world.pose(row).position).norm(), 0.225, 1e-3);
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
