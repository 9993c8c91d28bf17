// Joints of any robot: a footbot's and a handbot's compared with their specific devices, and a robot with other joints.
#include "swarmanoid_interface/devices/joints.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

using JointsActuator = ActuatorUnderTest<Joints>;
using JointsSensor = SensorUnderTest<JointStates>;
using Mode = JointCommand::Mode;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void expectCommand(const JointCommand& found, Mode mode, double value) {
  EXPECT_EQ(found.mode, mode);
  EXPECT_EQ(found.value, value);
}

/// A footbot with other joints: each stops at -0.25 and 0.35 rad, and turns with at most 0.8 rad/s.
std::shared_ptr<EntityModel> crane(std::size_t joints) {
  auto model = std::make_shared<EntityModel>(*robotModel("footbot"));
  model->type = "crane";
  EntityModel::Joint joint = model->joints.front();
  joint.lower = -0.25;
  joint.upper = 0.35;
  joint.max_speed = 0.8;
  model->joints.clear();
  for (std::size_t i = 0; i < joints; ++i) {
    joint.name = "boom_" + std::to_string(i);
    model->joints.push_back(joint);
  }
  return model;
}

TEST(JointsTest, HoldTheAngleZeroFromTheStart) {
  DeviceWorld world;
  const Row robot = world.add(crane(3), {1.0, 1.0, 0.0});
  const JointsActuator joints(world, robot);
  for (std::size_t i = 0; i < 3; ++i) {
    expectCommand(world.space.joint_commands[robot][i], Mode::kAngle, 0.0);
  }
}

TEST(JointsTest, AnglesAreCutToTheStopsAndSpeedsToTheMotors) {
  DeviceWorld world;
  const Row robot = world.add(crane(5), {1.0, 1.0, 0.0});
  JointsActuator joints(world, robot);
  joints.command.joints[0].holdAngle(0.31);
  joints.command.joints[1].holdAngle(0.36);
  joints.command.joints[2].turnAt(-0.9);
  joints.command.joints[3].letTurn();
  joints.command.joints[4].holdAngle(-1e300);
  joints.command.joints[5].holdAngle(0.1);  // the robot does not have it
  const Joints& actuation = joints.actuate();
  EXPECT_EQ(actuation.joints[1].angle, 0.35);
  EXPECT_EQ(actuation.joints[2].speed, -0.8);
  EXPECT_EQ(actuation.joints[4].angle, -0.25);
  const Span<const JointCommand> commands = world.space.joint_commands[robot];
  ASSERT_EQ(commands.size(), 5U);
  expectCommand(commands[0], Mode::kAngle, 0.31);
  expectCommand(commands[1], Mode::kAngle, 0.35);
  expectCommand(commands[2], Mode::kSpeed, -0.8);
  expectCommand(commands[3], Mode::kPassive, 0.0);
  expectCommand(commands[4], Mode::kAngle, -0.25);
}

TEST(JointsTest, CommandAFootbotsTurretAsItsOwnDeviceDoes) {
  DeviceWorld world;
  const Row with_turret = world.addFootbot(1.0, 1.0);
  const Row with_joints = world.addFootbot(2.0, 1.0);
  ActuatorUnderTest<FootbotTurret> turret(world, with_turret);
  JointsActuator joints(world, with_joints);
  const auto expectSame = [&](Mode mode, double value) {
    turret.actuate();
    joints.actuate();
    expectCommand(world.space.joint_commands[with_turret][0], mode, value);
    expectCommand(world.space.joint_commands[with_joints][0], mode, value);
  };
  expectSame(Mode::kAngle, 0.0);
  turret.command.holdAngle(7.7);
  joints.command.joints[0].holdAngle(7.7);
  expectSame(Mode::kAngle, 7.7);  // without stops
  turret.command.turnAt(3.4);
  joints.command.joints[0].turnAt(3.4);
  expectSame(Mode::kSpeed, 3.0);
  EXPECT_TRUE(turret.stop());
  EXPECT_TRUE(joints.stop());
  expectSame(Mode::kSpeed, 0.0);
  turret.command.letTurn();
  joints.command.joints[0].letTurn();
  turret.stop();
  joints.stop();
  expectSame(Mode::kPassive, 0.0);
}

TEST(JointsTest, CommandAHandbotsArmsAsTheirOwnDeviceDoes) {
  DeviceWorld world;
  const Row with_arms = world.add(robotModel("handbot"), {1.0, 1.0, 0.0});
  const Row with_joints = world.add(robotModel("handbot"), {2.0, 1.0, 0.0});
  ActuatorUnderTest<HandbotArms> arms(world, with_arms);
  JointsActuator joints(world, with_joints);
  arms.command.left = {-2.0, 1.3, 4.0};
  arms.command.right = {0.5, -0.55, 0.25};
  const double angles[] = {-2.0, 1.3, 4.0, 0.5, -0.55, 0.25};
  const double limited[] = {-1.57, 1.2, 3.14, 0.5, -0.55, 0.25};
  for (std::size_t i = 0; i < 6; ++i) {
    joints.command.joints[i].holdAngle(angles[i]);
  }
  arms.actuate();
  joints.actuate();
  const EntityModel& model = *world.space.entities.model[with_arms];
  ASSERT_EQ(model.joints.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(model.joints[i].name, HandbotArmsState::kNames[i]) << "the order of the model";
    expectCommand(world.space.joint_commands[with_arms][i], Mode::kAngle, limited[i]);
    expectCommand(world.space.joint_commands[with_joints][i], Mode::kAngle, limited[i]);
  }
  joints.command.joints[4].turnAt(2.5);
  joints.actuate();
  expectCommand(world.space.joint_commands[with_joints][4], Mode::kSpeed, 2.0);
}

TEST(JointsTest, WhatIsNoNumberIsFaultyAndASafeStopHoldsWhatTurns) {
  DeviceWorld world;
  const Row robot = world.add(crane(3), {1.0, 1.0, 0.0});
  JointsActuator joints(world, robot);
  joints.command.joints[0].holdAngle(0.2);
  joints.command.joints[1].letTurn();
  joints.command.joints[2].turnAt(-0.4);
  joints.actuate();
  joints.command.joints[2].speed = kNan;
  joints.actuate();
  EXPECT_EQ(joints.faulty, std::vector<Row>{robot});
  expectCommand(world.space.joint_commands[robot][2], Mode::kSpeed, -0.4);
  EXPECT_TRUE(joints.stop());
  joints.actuate();
  EXPECT_TRUE(joints.faulty.empty());
  expectCommand(world.space.joint_commands[robot][0], Mode::kSpeed, 0.0);
  expectCommand(world.space.joint_commands[robot][1], Mode::kPassive, 0.0);
  expectCommand(world.space.joint_commands[robot][2], Mode::kSpeed, 0.0);
}

TEST(JointsTest, ErrorsActOnOneJointAndBeforeItsStops) {
  DeviceWorld world;
  const Row robot = world.add(crane(3), {1.0, 1.0, 0.0});
  JointsActuator joints(world, robot, {}, {bias("joints[1].angle", "0.125")});
  joints.command.joints[0].holdAngle(0.125);
  joints.command.joints[1].holdAngle(0.125);
  joints.actuate();
  expectCommand(world.space.joint_commands[robot][0], Mode::kAngle, 0.125);
  expectCommand(world.space.joint_commands[robot][1], Mode::kAngle, 0.25);
  joints.command.joints[1].holdAngle(0.25);
  joints.actuate();
  expectCommand(world.space.joint_commands[robot][1], Mode::kAngle, 0.35);
}

TEST(JointStatesTest, AreThoseOfTheRobotsJointsInTheirOrder) {
  DeviceWorld world;
  const Row other = world.add(crane(3), {3.0, 1.0, 0.0});
  const Row robot = world.add(crane(3), {1.0, 1.0, 0.0});
  JointsSensor states(world, robot);
  ASSERT_EQ(states.sense().joints.size(), 3U);
  EXPECT_EQ(states.sense().joints[2].angle, 0.0);
  world.space.joints[other][1] = {9.0, 9.0, 9.0};
  world.space.joints[robot][0] = {-0.21, 0.6, -1.5};
  world.space.joints[robot][2] = {0.34, -0.1, 2.25};
  const Span<const JointStates::Joint> joints = states.sense().joints;
  EXPECT_EQ(joints[0].angle, -0.21);
  EXPECT_EQ(joints[0].speed, 0.6);
  EXPECT_EQ(joints[0].effort, -1.5);
  EXPECT_EQ(joints[1].angle, 0.0);
  EXPECT_EQ(joints[2].angle, 0.34);
  EXPECT_EQ(joints[2].speed, -0.1);
  EXPECT_EQ(joints[2].effort, 2.25);
}

TEST(JointStatesTest, StayWhereTheyAreWhenMoreRobotsCome) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  JointsSensor states(world, robot);
  const JointStates::Joint* const readings = states.sense().joints.data();
  for (int i = 0; i < 50; ++i) {
    states.sensor->add(world.space, world.addFootbot(2.0 + 0.1 * i, 3.0));
  }
  EXPECT_EQ(states.sense().joints.data(), readings);
  world.space.joints[robot][0].angle = 0.5;
  EXPECT_EQ(states.sense().joints[0].angle, 0.5) << "it is written where it is read";
}

TEST(JointStatesTest, ErrorsActOnTheSpan) {
  DeviceWorld world;
  const Row robot = world.add(crane(16), {1.0, 1.0, 0.0});
  JointsSensor states(world, robot, {}, {bias("joints[].angle", "0.125")});
  world.space.joints[robot][15] = {0.25, 0.5, 1.0};
  EXPECT_EQ(states.sense().joints[0].angle, 0.125);
  EXPECT_EQ(states.sense().joints[15].angle, 0.375);
  EXPECT_EQ(states.sense().joints[15].speed, 0.5);
}

TEST(JointStatesTest, SensingAndActuatingAllocateNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  DeviceWorld world;
  const Row robot = world.add(robotModel("handbot"), {1.0, 1.0, 0.0});
  JointsSensor states(world, robot);
  JointsActuator joints(world, robot);
  joints.command.joints[3].holdAngle(0.3);
  std::vector<Row> faulty;
  const long before = heap_allocations;
  states.sensor->sense(world.space, 0, 1);
  joints.actuator->actuate(world.space, ActuateAccess(world.space), faulty);
  EXPECT_EQ(heap_allocations - before, 0);
}

TEST(JointsTest, RobotsWithoutJointsOrWithTooManyAreRefused) {
  EXPECT_EQ(refusalOf<JointsActuator>(crane(16)), "");
  EXPECT_EQ(refusalOf<JointsActuator>(crane(0)),
            "found the device 'joints' on a crane, allowed: on robots with joints");
  EXPECT_EQ(refusalOf<JointsActuator>(crane(17)),
            "found the device 'joints' on a crane with 17 joints, allowed: on robots with 1 to 16");
  EXPECT_EQ(refusalOf<JointsSensor>(robotModel("eyebot")),
            "found the device 'joint_states' on a eyebot, allowed: on robots with joints");
  EXPECT_EQ(refusalOf<JointsSensor>(crane(17)),
            "found the device 'joint_states' on a crane with 17 joints, allowed: on robots with 1 to 16");
}

}  // namespace
}  // namespace swarmanoid::test
