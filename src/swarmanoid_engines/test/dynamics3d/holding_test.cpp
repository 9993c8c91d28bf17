// Grips of ropes and hands: both ends feel the force, and a grip ends when one of them is removed.
#include <gtest/gtest.h>

#include "handbot_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

struct Momentum {
  Vector3d linear = Vector3d::Zero();   // N s
  Vector3d angular = Vector3d::Zero();  // about the origin of W [N m s]
};

/// Momentum of an entity without arms.
Momentum momentumOf(const World& world, Row row) {
  const EntityModel& model = *world.space.entities.model[row];
  const Pose& pose = world.pose(row);
  const Twist& twist = world.twist(row);
  const Vector3d arm = pose.orientation * model.centre_of_mass;
  const Eigen::Matrix3d axes = pose.orientation.toRotationMatrix();
  Momentum result;
  result.linear = model.mass * (twist.linear + twist.angular.cross(arm));
  result.angular = (pose.position + arm).cross(result.linear) + axes * model.inertia * axes.transpose() * twist.angular;
  return result;
}

TEST(HoldingTest, ARopePullsBothEndsAlike) {
  HandbotWorld world({{"gravity", "0"}, {"ground", "false"}});
  // beside the ceiling and without gravity, the block not quite above the rope's launcher
  const Row robot = world.addRobot<HandbotRope>(robotModel("handbot"), flatPose(8.0, 8.0, 0.0, 0.2));
  const Row block = world.add(blockModel({0.4, 0.3, 0.2}, 5.0, true), flatPose(8.0, 8.05, 0.0, 1.6));
  world.rope(robot).shot = true;
  world.step(3);
  ASSERT_EQ(world.held(robot, kRope).held, block);
  const double length = world.held(robot, kRope).length;
  world.rope(robot).winding_speed = 0.2;
  for (int tick = 0; tick < 30; ++tick) {
    world.step();
    const Momentum up = momentumOf(world, robot);
    const Momentum down = momentumOf(world, block);
    ASSERT_LT((up.linear + down.linear).norm(), 1e-9) << "tick " << tick;
    ASSERT_LT((up.angular + down.angular).norm(), 0.01 * up.angular.norm()) << "tick " << tick;
  }
  EXPECT_GT(momentumOf(world, robot).linear.z(), 0.2);
  EXPECT_NEAR(world.held(robot, kRope).length, length - 0.6, 1e-9);
  const Vector3d anchor = world.pose(block).position + world.pose(block).orientation * world.held(robot, kRope).anchor;
  const Vector3d launcher = world.pose(robot).position +
                            world.pose(robot).orientation * robotModel("handbot")->mount("rope_launcher").position;
  EXPECT_NEAR((anchor - launcher).norm(), length - 0.6, 1e-3);
}

TEST(HoldingTest, TwoHandsHoldOneThing) {
  HandbotWorld world;
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  world.addBlock({0.2, 0.5, 0.09}, 0.0, flatPose(2.3, 2.0, 0.0, 0.045));  // a table
  const Row box = world.addBlock({0.06, 0.4, 0.12}, 0.2, flatPose(2.24, 2.0, 0.0, 0.15));
  world.hands(robot) = {true, true};
  world.step(5);
  ASSERT_EQ(world.held(robot, kLeftHand).held, box);
  ASSERT_EQ(world.held(robot, kRightHand).held, box);
  world.arms(robot).left.shoulder = -0.4;
  world.arms(robot).right.shoulder = -0.4;
  world.step(30);
  EXPECT_GT(world.pose(box).position.z(), 0.21);
  EXPECT_NEAR(world.held(robot, kLeftHand).force + world.held(robot, kRightHand).force, 0.2 * kGravity, 0.05);
  world.hands(robot).left = false;
  world.step(10);
  EXPECT_FALSE(world.space.attachments.isAttached(robot, kLeftHand));
  EXPECT_NEAR(world.held(robot, kRightHand).force, 0.2 * kGravity, 0.02);
  EXPECT_GT(world.pose(box).position.z(), 0.2);
}

TEST(HoldingTest, WhatIsTakenAwayIsHeldByNobody) {
  HandbotWorld world;
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  world.addBlock({0.2, 0.5, 0.09}, 0.0, flatPose(2.3, 2.0, 0.0, 0.045));  // a table
  const Row box = world.addBlock({0.06, 0.4, 0.12}, 0.2, flatPose(2.24, 2.0, 0.0, 0.15));
  world.hands(robot) = {true, true};
  world.rope(robot).shot = true;
  world.step(10);
  ASSERT_EQ(world.held(robot, kRope).held, world.ceiling);
  ASSERT_EQ(world.held(robot, kRightHand).held, box);
  world.remove(box);
  world.remove(world.ceiling);
  // the new ceiling is another entity, and the rope was not called back
  world.ceiling = world.add(blockModel({5.0, 5.0, 0.1}, 0.0, true), flatPose(2.5, 2.5, 0.0, kCeiling + 0.05));
  world.step(20);
  EXPECT_FALSE(world.space.attachments.isAttached(robot));
  EXPECT_LT((world.pose(robot).position - Vector3d(2.0, 2.0, 0.0)).norm(), 5e-3);
  world.rope(robot).shot = false;
  world.step();
  world.rope(robot).shot = true;
  world.step(10);
  EXPECT_EQ(world.held(robot, kRope).held, world.ceiling);
}

TEST(HoldingTest, WhoIsPutElsewhereLetsGo) {
  HandbotWorld world;
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  world.rope(robot).shot = true;
  world.rope(robot).winding_speed = 0.1;
  world.step(60);
  ASSERT_TRUE(world.space.attachments.isAttached(robot, kRope));
  ASSERT_GT(world.pose(robot).position.z(), 0.3);
  world.place(robot, flatPose(3.0, 3.0));
  world.step(20);
  EXPECT_FALSE(world.space.attachments.isAttached(robot));
  EXPECT_LT((world.pose(robot).position - Vector3d(3.0, 3.0, 0.0)).norm(), 5e-3);
  EXPECT_LT(tiltOf(world.pose(robot)), 0.01);
}

TEST(HoldingTest, MirrorsNeitherHoldNorAreHeld) {
  HandbotWorld world;
  Dynamics3d other;
  const auto addMirrorOfOther = [&](const std::shared_ptr<const EntityModel>& model, const Pose& pose) {
    const Row row = world.addToSpace(model, pose);
    world.space.mover[row] = &other;
    test::carryOut(world.space);
    world.engine.add(world.space, row, Role::kMirror);
    return row;
  };
  const Row mirror = world.addHandbot(flatPose(3.0, 3.0), Role::kMirror);
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  addMirrorOfOther(blockModel({0.06, 0.4, 0.12}, 0.2), flatPose(2.24, 2.0, 0.0, 0.15));
  addMirrorOfOther(blockModel({0.4, 0.4, 0.1}, 1.0, true), flatPose(2.0, 2.0, 0.0, 1.0));
  for (const Row row : {mirror, robot}) {
    world.hands(row) = {true, true};
    world.rope(row).shot = true;
  }
  world.step(10);
  EXPECT_FALSE(world.space.attachments.isAttached(mirror));
  EXPECT_FALSE(world.space.attachments.isAttached(robot, kLeftHand));
  EXPECT_FALSE(world.space.attachments.isAttached(robot, kRightHand));
  EXPECT_EQ(world.held(robot, kRope).held, world.ceiling) << "through the mirror";
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
