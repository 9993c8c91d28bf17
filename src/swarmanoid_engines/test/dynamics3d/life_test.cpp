// Entities that the engine refuses, and changes between ticks.
#include <gtest/gtest.h>

#include "dynamics3d/collision/convex_overlap.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_space/rays/solid_ray.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

std::shared_ptr<const EntityModel> boxModel(double x, double y, double z) { return blockModel({x, y, z}, 1.0); }

TEST(LifeTest, StepsOverTenMillisecondsAreRefusedWithWhatIsAllowed) {
  const World coarse({{"subclock", "9"}});
  EXPECT_EQ(coarse.engine.unsupportedClocktickReason(std::chrono::milliseconds(100)),
            "subclock: found 9 with ticks of 100 ms, which makes steps of 11.1111 ms; allowed: steps of at most 10 ms, "
            "here a subclock from 10");
  const World fine({{"subclock", "10"}});
  EXPECT_EQ(fine.engine.unsupportedClocktickReason(std::chrono::milliseconds(100)), "");
  EXPECT_NE(fine.engine.unsupportedClocktickReason(std::chrono::nanoseconds(100100000)), "");
}

TEST(LifeTest, UnsupportedReasonsNameWhatIsMissing) {
  const World world;
  EXPECT_EQ(world.engine.unsupportedReason(*robotModel("footbot"), test::uses({"footbot_wheels", "footbot_gripper"})),
            "");
  EXPECT_EQ(world.engine.unsupportedReason(*robotModel("handbot"), {}), "");
  EXPECT_EQ(world.engine.unsupportedReason(*blockModel({1.0, 1.0, 1.0}), {}), "");
  EXPECT_EQ(world.engine.unsupportedReason(*robotModel("eyebot"), test::uses({"footbot_wheels"})),
            "device 'footbot_wheels' cannot be simulated: a robot of this type has no wheels");
  EXPECT_EQ(world.engine.unsupportedReason(*lightModel(), {}), "has no shape, so this engine has nothing to hold");
  EntityModel massless = *robotModel("footbot");
  massless.mass = 0.0;
  EXPECT_EQ(world.engine.unsupportedReason(massless, {}), "has no mass, so this engine cannot move it");
  EntityModel flat = *robotModel("footbot");
  flat.inertia.setZero();
  EXPECT_EQ(world.engine.unsupportedReason(flat, {}), "has an inertia that no body has, so this engine cannot move it");
}

TEST(LifeTest, WhereTheLibraryGivesUpTheProcessDoesNot) {
  World world;
  world.add(cylindricPreyModel(0.1, 0.1), flatPose(1.0, 1.0));
  const auto messageOf = [](auto give_up) {
    std::string message;
    try {
      give_up();
    } catch (const std::exception& error) {
      message = error.what();
    }
    return message;
  };
  EXPECT_EQ(messageOf([] { dError(7, "%d bodies", 3); }), "the ODE library gives up (7): 3 bodies");
  EXPECT_EQ(messageOf([] { dDebug(d_ERR_IASSERT, "bad"); }), "the ODE library gives up (1): bad");
}

TEST(LifeTest, NothingIsPlacedInTheGround) {
  const World world({{"ground_height", "0.5"}});
  const auto prey = cylindricPreyModel(0.1, 0.1);
  EXPECT_EQ(world.engine.invalidPoseReason(*prey, flatPose(1.0, 1.0, 0.0, 0.5)), "");
  EXPECT_EQ(world.engine.invalidPoseReason(*prey, flatPose(1.0, 1.0, 0.0, 2.0)), "");
  EXPECT_EQ(world.engine.invalidPoseReason(*prey, flatPose(1.0, 1.0, 0.0, 0.4)),
            "found at z = 0.4, where it reaches down to z = 0.4, allowed: above the ground, which is at z = 0.5");
  const Pose tilted{{1.0, 1.0, 0.5}, Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vector3d::UnitX()))};
  EXPECT_NE(world.engine.invalidPoseReason(*prey, tilted), "");
  EXPECT_EQ(world.engine.invalidPoseReason(*prey, {{1.0, 1.0, 0.6}, tilted.orientation}), "");
  EXPECT_EQ(world.engine.invalidPoseReason(*blockModel({1.0, 1.0, 1.0}), flatPose(1.0, 1.0)), "");  // it does not move
  const World bottomless({{"ground", "false"}});
  EXPECT_EQ(bottomless.engine.invalidPoseReason(*prey, flatPose(1.0, 1.0, 0.0, -9.0)), "");
}

TEST(LifeTest, TouchingIsNoOverlap) {
  World world;
  const Row block = world.add(boxModel(0.4, 0.4, 0.2), flatPose(2.0, 2.0, 0.0, 0.1));
  const auto cylinder = cylindricPreyModel(0.1, 0.2);
  const auto at = [&](const std::shared_ptr<const EntityModel>& model, double x, double y, double z) {
    return world.engine.overlap(*model, flatPose(x, y, 0.0, z), kNoRow);
  };
  EXPECT_EQ(at(boxModel(0.2, 0.2, 0.2), 2.3, 2.0, 0.1), kNoRow);  // beside it
  EXPECT_EQ(at(boxModel(0.2, 0.2, 0.2), 2.29999, 2.0, 0.1), block);
  EXPECT_EQ(at(cylinder, 2.0, 2.0, 0.2), kNoRow);  // on it
  EXPECT_EQ(at(cylinder, 2.0, 2.0, 0.19999), block);
  EXPECT_EQ(at(cylinder, 2.3, 2.0, 0.0), kNoRow);
  EXPECT_EQ(at(cylinder, 2.29999, 2.0, 0.0), block);
  EXPECT_EQ(at(cylinder, 2.0, 2.0, 0.05), block);  // entirely within it
  EXPECT_EQ(world.engine.overlap(*cylinder, flatPose(2.0, 2.0), block), kNoRow);
}

TEST(LifeTest, OverlapIsThatOfSolids) {
  // against points of one solid that are inside the other, at random poses
  std::srand(3);
  const auto random = [] { return std::rand() / (RAND_MAX + 1.0) - 0.5; };
  EntityModel sphere;
  sphere.shapes.push_back({CollisionShape::Kind::kSphere, Vector3d::Constant(0.12), Vector3d::Zero()});
  const std::vector<EntityModel> models{*boxModel(0.3, 0.2, 0.1), *cylindricPreyModel(0.1, 0.25), sphere};
  int overlapping = 0;
  for (int i = 0; i < 3000; ++i) {
    const EntityModel& a = models[static_cast<std::size_t>(i % 3)];
    const EntityModel& b = models[static_cast<std::size_t>(i / 3 % 3)];
    const auto pose = [&] {
      return Pose{0.5 * Vector3d(random(), random(), random()),
                  Eigen::Quaterniond(random(), random(), random(), random()).normalized()};
    };
    const Pose pose_a = pose();
    const Pose pose_b = pose();
    const bool overlap = modelsOverlap(a, pose_a, b, pose_b);
    ASSERT_EQ(modelsOverlap(b, pose_b, a, pose_a), overlap);
    overlapping += overlap ? 1 : 0;
    for (int k = 0; k < 60 && !overlap; ++k) {
      // a segment of no length hits a solid if it is inside
      const Vector3d point = pose_a.position + 0.4 * Vector3d(random(), random(), random());
      ASSERT_FALSE(closestHit({point, point}, a, pose_a) <= 1.0 && closestHit({point, point}, b, pose_b) <= 1.0);
    }
    const Vector3d to_b = pose_b.position - pose_a.position;
    const Pose apart{pose_a.position + 1.0 * to_b.normalized(), pose_b.orientation};
    ASSERT_FALSE(modelsOverlap(a, pose_a, b, apart));
    ASSERT_TRUE(modelsOverlap(a, pose_a, b, {pose_a.position, pose_b.orientation}));
  }
  EXPECT_GT(overlapping, 500);
  EXPECT_LT(overlapping, 2500);
}

TEST(LifeTest, OverlapIsExactForSolidsOfAnySize) {
  // spheres beyond a corner of blocks: the corner is nearest to them
  std::srand(5);
  const auto random = [](double low, double high) { return low + (high - low) * (std::rand() / (RAND_MAX + 1.0)); };
  for (const double size : {1e-4, 1e-3, 1e-2, 1.0, 100.0}) {
    for (int i = 0; i < 5000; ++i) {
      const double radius = size * random(0.5, 20.0);
      EntityModel sphere;
      sphere.shapes.push_back({CollisionShape::Kind::kSphere, Vector3d::Constant(radius), Vector3d::Zero()});
      const EntityModel block = *boxModel(size * random(1, 20), size * random(1, 20), size * random(1, 20));
      const Vector3d corner = block.shapes[0].position + block.shapes[0].half_extent;
      const Vector3d away = Vector3d(random(0, 1), random(0, 1), random(0, 1)).normalized();
      const Eigen::Quaterniond turn(
          Eigen::AngleAxisd(random(0, 6), Vector3d(random(-1, 1), random(-1, 1), 1).normalized()));
      const auto overlap = [&](double gap) {
        return modelsOverlap(block, {Vector3d::Zero(), turn}, sphere, {turn * (corner + (radius + gap) * away), turn});
      };
      ASSERT_FALSE(overlap(1e-8)) << size;
      ASSERT_TRUE(overlap(-2.0 * kContactTolerance)) << size;
    }
  }
}

TEST(LifeTest, WhatIsRemovedIsGone) {
  World world;
  const Row footbot = world.addFootbot(flatPose(2.0, 2.0));
  const Row block = world.addBlock({0.2, 1.0, 0.5}, 0.0, flatPose(2.4, 2.0, 0.0, 0.25));
  world.drive(footbot, 0.2);
  world.step(20);
  EXPECT_NEAR(world.pose(footbot).position.x(), 2.3 - 0.11, 2e-3);
  EXPECT_EQ(world.castRay({2.2, 2.0, 0.2}, {2.6, 2.0, 0.2}, footbot).row, block);
  world.remove(block);
  EXPECT_EQ(world.castRay({2.2, 2.0, 0.2}, {2.6, 2.0, 0.2}, footbot).row, kNoRow);
  world.step(20);
  EXPECT_GT(world.pose(footbot).position.x(), 2.5);
}

TEST(LifeTest, WhatIsPutElsewhereGoesOnFromThere) {
  World world;
  const Row footbot = world.addFootbot(flatPose(2.0, 2.0));
  world.drive(footbot, 0.2);
  world.step(10);
  world.pose(footbot) = flatPose(5.0, 5.0, M_PI / 2.0);
  world.twist(footbot) = Twist{};
  world.engine.place(world.space, footbot);
  world.step(10);
  EXPECT_NEAR(world.pose(footbot).position.x(), 5.0, 1e-3);
  EXPECT_NEAR(world.pose(footbot).position.y(), 5.2, 0.01);
}

TEST(LifeTest, AHandoverKeepsPoseAndTwist) {
  World world({{"ground", "false"}});
  const Row block = world.addToSpace(boxModel(0.1, 0.2, 0.3), flatPose(1.0, 1.0, 0.3, 1.0));
  world.twist(block) = {{1.0, 2.0, 3.0}, {0.1, 0.2, 0.3}};
  test::carryOut(world.space);
  world.engine.add(world.space, block, Role::kMove);
  World other({{"ground", "false"}});
  const Row twin = other.addToSpace(boxModel(0.1, 0.2, 0.3), flatPose(1.0, 1.0, 0.3, 1.0));
  other.twist(twin) = world.twist(block);
  test::carryOut(other.space);
  other.engine.add(other.space, twin, Role::kMove);
  world.step(10);
  other.step(5);
  other.engine.remove(other.space, twin);
  test::carryOut(other.space);
  other.engine.add(other.space, twin, Role::kMove);
  other.step(5);
  EXPECT_LT((world.pose(block).position - other.pose(twin).position).norm(), 1e-12);
  EXPECT_LT(world.pose(block).orientation.angularDistance(other.pose(twin).orientation), 1e-7);
  EXPECT_LT((world.twist(block).angular - other.twist(twin).angular).norm(), 1e-12);
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
