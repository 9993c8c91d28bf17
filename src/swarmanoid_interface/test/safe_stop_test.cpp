#include "swarmanoid_interface/safe_stop.hpp"

#include <gtest/gtest.h>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {
namespace {

Bytes bytesOf(const std::string& type, const void* device) {
  Bytes bytes;
  ByteWriter writer(bytes);
  findDeviceType(type)->write(device, writer);
  return bytes;
}

struct SafeStopTest : testing::Test {
  template <class Device>
  bool stop(Device& command, double since = 0.0) {
    return findDeviceType(Device::kType)->stop(&command, {since, settings, robot});
  }
  template <class Device>
  void expectAsItIs(Device command) {
    const Bytes before = bytesOf(Device::kType, &command);
    EXPECT_NE(before, bytesOf(Device::kType, std::make_unique<Device>().get())) << "no test of " << Device::kType;
    EXPECT_TRUE(stop(command));
    EXPECT_EQ(before, bytesOf(Device::kType, &command)) << Device::kType;
  }

  SafeStopSettings settings;
  Robot robot{"r", "robot", 1};
};

TEST_F(SafeStopTest, FootbotStandsStill) {
  FootbotWheels wheels{3.0, -2.0};
  EXPECT_TRUE(stop(wheels));
  EXPECT_EQ(0.0, wheels.left);
  EXPECT_EQ(0.0, wheels.right);
}

TEST_F(SafeStopTest, TurretStopsButAPassiveOneStaysPassive) {
  FootbotTurret turret;
  for (const auto& command :
       {FootbotTurret{FootbotTurret::Mode::kSpeed, 0.0, 2.0}, FootbotTurret{FootbotTurret::Mode::kAngle, 1.0, 0.0}}) {
    turret = command;
    EXPECT_TRUE(stop(turret));
    EXPECT_EQ(FootbotTurret::Mode::kSpeed, turret.mode);
    EXPECT_EQ(0.0, turret.speed);
  }
  turret.letTurn();
  EXPECT_TRUE(stop(turret));
  EXPECT_EQ(FootbotTurret::Mode::kPassive, turret.mode);
}

TEST_F(SafeStopTest, EyebotHoversAndThenComesDown) {
  settings = {2.0, 0.4, 5.0};
  EyebotVelocity velocity;
  const auto command_at = [&](double since, bool is_done) {
    velocity.linear = {0.3, 0.2, 0.1};
    velocity.yaw_rate = 1.0;
    EXPECT_EQ(is_done, stop(velocity, since)) << since;
    EXPECT_EQ(0.0, velocity.yaw_rate);
    return Eigen::Vector3d(velocity.linear);
  };
  EXPECT_EQ(Eigen::Vector3d(0.0, 0.0, 0.0), command_at(0.0, false));
  EXPECT_EQ(Eigen::Vector3d(0.0, 0.0, 0.0), command_at(1.99, false));
  EXPECT_EQ(Eigen::Vector3d(0.0, 0.0, -0.4), command_at(2.0, false));
  EXPECT_EQ(Eigen::Vector3d(0.0, 0.0, -0.4), command_at(6.99, false));
  EXPECT_EQ(Eigen::Vector3d(0.0, 0.0, 0.0), command_at(7.0, true));
}

TEST_F(SafeStopTest, EyebotThatHangsStays) {
  EyebotMagnetState magnet{true};
  robot.provideSensor(EyebotMagnetState::kType, &magnet);
  EyebotVelocity velocity;
  EXPECT_TRUE(stop(velocity, 3.0));
  EXPECT_EQ(0.0, velocity.linear.z());
  magnet.attached = false;
  EXPECT_FALSE(stop(velocity, 3.0));
  EXPECT_EQ(-settings.descend_speed, velocity.linear.z());
}

TEST_F(SafeStopTest, LaserIsOff) {
  EyebotLaser laser{true, 0.5, 0.2};
  EXPECT_TRUE(stop(laser));
  EXPECT_FALSE(laser.on);
}

TEST_F(SafeStopTest, RopeIsHeld) {
  HandbotRope rope{true, 0.1};
  EXPECT_TRUE(stop(rope));
  EXPECT_TRUE(rope.shot);
  EXPECT_EQ(0.0, rope.winding_speed);
}

TEST_F(SafeStopTest, WhatIsHeldIsNotDropped) {
  expectAsItIs(FootbotGripper{true});
  expectAsItIs(EyebotMagnet{true});
  expectAsItIs(HandbotHands{true, true});
  expectAsItIs(HandbotArms{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}});
  FootbotLeds footbot_leds;
  footbot_leds.setAll(colors::kBlue);
  expectAsItIs(footbot_leds);
  EyebotLeds eyebot_leds;
  eyebot_leds.setAll(colors::kBlue);
  expectAsItIs(eyebot_leds);
}

}  // namespace
}  // namespace swarmanoid
