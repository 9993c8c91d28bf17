// Devices of handbots, and the eyebot's magnet: limits of commands, and readings from the space.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid::test {
namespace {

// Indices of holders in the handbot's model.
constexpr std::size_t kRightHand = 1;
constexpr std::size_t kRope = 2;
constexpr std::size_t kMagnet = 0;  // of the eyebot

Row addHandbot(DeviceWorld& world) { return world.add(robotModel("handbot"), {1.0, 1.0, 0.0}); }

TEST(HandbotArmsTest, AnglesStayWithinTheJointsLimits) {
  DeviceWorld world;
  ActuatorUnderTest<HandbotArms> arms(world, addHandbot(world));
  arms.command.left = {-2.0, 1.3, 4.0};
  arms.command.right = {0.5, -0.5, 0.25};
  const HandbotArms& actuation = arms.actuate();
  EXPECT_EQ(actuation.left.shoulder, -1.57);
  EXPECT_EQ(actuation.left.elbow, 1.2);
  EXPECT_EQ(actuation.left.wrist, 3.14);
  EXPECT_EQ(actuation.right.shoulder, 0.5);
  EXPECT_EQ(actuation.right.elbow, -0.5);
  EXPECT_EQ(actuation.right.wrist, 0.25);
}

TEST(HandbotArmsTest, WhatIsNoNumberIsFaulty) {
  DeviceWorld world;
  const Row robot = addHandbot(world);
  ActuatorUnderTest<HandbotArms> arms(world, robot);
  arms.command.right.wrist = std::numeric_limits<double>::quiet_NaN();
  arms.actuate();
  EXPECT_EQ(arms.faulty, std::vector<Row>{robot});
}

TEST(HandbotArmsTest, TheStateIsThatOfTheJoints) {
  DeviceWorld world;
  const Row robot = addHandbot(world);
  SensorUnderTest<HandbotArmsState> state(world, robot);
  const int elbow = robotModel("handbot")->findJoint("right_elbow");
  world.space.joints[robot][elbow] = {0.3, -0.2, 1.5};
  const HandbotArmsState& readings = state.sense();
  EXPECT_STREQ(HandbotArmsState::kNames[4], "right_elbow");
  EXPECT_EQ(readings.joints[4].angle, 0.3);
  EXPECT_EQ(readings.joints[4].speed, -0.2);
  EXPECT_EQ(readings.joints[4].effort, 1.5);
  EXPECT_EQ(readings.joints[0].angle, 0.0);
}

TEST(HandbotRopeTest, WindingIsLimitedAndTheStateIsRead) {
  DeviceWorld world;
  const Row robot = addHandbot(world);
  const Row ceiling = world.addWall({1.0, 1.0, 0.1}, {1.0, 1.0});
  ActuatorUnderTest<HandbotRope> rope(world, robot, {{"max_speed", "0.3"}});
  rope.command = {true, 5.0};
  EXPECT_EQ(rope.actuate().winding_speed, 0.3);
  EXPECT_TRUE(rope.actuate().shot);
  rope.command.winding_speed = -5.0;
  EXPECT_EQ(rope.actuate().winding_speed, -0.3);
  SensorUnderTest<HandbotRopeState> state(world, robot);
  EXPECT_FALSE(state.sense().attached);
  world.space.attachments.attach(robot, kRope, {ceiling, {0.0, 0.0, 0.0}, 1.25, 28.0});
  EXPECT_TRUE(state.sense().attached);
  EXPECT_EQ(state.sense().length, 1.25);
  EXPECT_EQ(state.sense().tension, 28.0);
}

TEST(HandbotRopeTest, ASafeStopHoldsItWhateverTheControllerSaidLast) {
  DeviceWorld world;
  const Row robot = addHandbot(world);
  ActuatorUnderTest<HandbotRope> rope(world, robot);
  rope.command = {true, 0.1};
  rope.actuate();
  rope.command.winding_speed = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(rope.actuate().shot);
  EXPECT_EQ(rope.faulty, std::vector<Row>{robot});
  EXPECT_TRUE(rope.stop());
  for (const HandbotRope* command : {static_cast<const HandbotRope*>(&rope.command), &rope.actuate()}) {
    EXPECT_TRUE(command->shot);
    EXPECT_EQ(command->winding_speed, 0.0);
  }
  EXPECT_TRUE(rope.faulty.empty());
}

TEST(HandbotHandsTest, EachHandIsItsOwn) {
  DeviceWorld world;
  const Row robot = addHandbot(world);
  const Row prey = world.addPrey(1.3, 1.0);
  ActuatorUnderTest<HandbotHands> hands(world, robot);
  hands.command.right = true;
  EXPECT_FALSE(hands.actuate().left);
  EXPECT_TRUE(hands.actuate().right);
  SensorUnderTest<HandbotHandsState> state(world, robot);
  world.space.attachments.attach(robot, kRightHand, {prey, {0.0, 0.0, 0.0}, 0.0, 2.5});
  EXPECT_FALSE(state.sense().left.holding);
  EXPECT_TRUE(state.sense().right.holding);
  EXPECT_EQ(state.sense().right.force, 2.5);
}

TEST(EyebotMagnetTest, TheSwitchSaysWhetherItHolds) {
  DeviceWorld world;
  const Row robot = world.addEyebot(1.0, 1.0, 1.0);
  const Row ceiling = world.addWall({1.0, 1.0, 0.1}, {1.0, 1.0});
  ActuatorUnderTest<EyebotMagnet> magnet(world, robot);
  magnet.command.on = true;
  EXPECT_TRUE(magnet.actuate().on);
  SensorUnderTest<EyebotMagnetState> state(world, robot);
  EXPECT_FALSE(state.sense().attached);
  world.space.attachments.attach(robot, kMagnet, {ceiling, {0.0, 0.0, 0.0}, 0.0, 19.6});
  EXPECT_TRUE(state.sense().attached);
}

}  // namespace
}  // namespace swarmanoid::test
