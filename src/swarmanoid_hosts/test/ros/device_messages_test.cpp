// Converts devices to messages and back.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "message_bench.hpp"
#include "swarmanoid_hosts/ros/devices/color_blob_camera.hpp"
#include "swarmanoid_hosts/ros/devices/differential_drive.hpp"
#include "swarmanoid_hosts/ros/devices/eyebot_laser.hpp"
#include "swarmanoid_hosts/ros/devices/eyebot_magnet.hpp"
#include "swarmanoid_hosts/ros/devices/eyebot_pan_tilt.hpp"
#include "swarmanoid_hosts/ros/devices/eyebot_velocity.hpp"
#include "swarmanoid_hosts/ros/devices/footbot_gripper.hpp"
#include "swarmanoid_hosts/ros/devices/footbot_ground.hpp"
#include "swarmanoid_hosts/ros/devices/footbot_proximity.hpp"
#include "swarmanoid_hosts/ros/devices/footbot_turret.hpp"
#include "swarmanoid_hosts/ros/devices/footbot_wheels.hpp"
#include "swarmanoid_hosts/ros/devices/handbot_arms.hpp"
#include "swarmanoid_hosts/ros/devices/handbot_hands.hpp"
#include "swarmanoid_hosts/ros/devices/handbot_rope.hpp"
#include "swarmanoid_hosts/ros/devices/led_array.hpp"
#include "swarmanoid_hosts/ros/devices/leds.hpp"
#include "swarmanoid_hosts/ros/devices/wheels.hpp"

namespace swarmanoid {
namespace {

using test::bytesOf;
using test::expectNothingLost;
using test::refusalOf;

TEST(DeviceMessages, KeepAllReadings) {
  FootbotProximity proximity;
  for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
    proximity.value[i] = 0.01F * static_cast<float>(i);
  }
  expectNothingLost<swarmanoid_msgs::ProximityArray>(proximity);
  expectNothingLost<swarmanoid_msgs::GroundArray>(FootbotGround{{0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F, 0.7F, 0.8F}});
  expectNothingLost<swarmanoid_msgs::GroundArray>(FootbotBaseGround{{0.5F, 0.0F, 1.0F, 0.25F}});
  expectNothingLost<swarmanoid_msgs::GripperState>(FootbotGripperState{true});
  expectNothingLost<sensor_msgs::JointState>(FootbotTurretState{0.1, 0.2, 0.3});
  expectNothingLost<swarmanoid_msgs::GripperState>(EyebotMagnetState{true});
  expectNothingLost<swarmanoid_msgs::HandsState>(HandbotHandsState{{true, 1.5}, {false, 2.5}});
  expectNothingLost<swarmanoid_msgs::RopeState>(HandbotRopeState{true, 1.25, 7.5});
  HandbotArmsState arms;
  for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
    arms.joints[i] = {0.1 * static_cast<double>(i), 1.0, -static_cast<double>(i)};
  }
  expectNothingLost<sensor_msgs::JointState>(arms);
}

TEST(DeviceMessages, KeepAllBlobs) {
  const std::array<ColorBlob, 2> blobs{ColorBlob{{255, 0, 1}, 0.5F, 1.5F, -0.75F, 0.125F},
                                       ColorBlob{{3, 2, 255}, -3.0F, 0.25F, 1.25F, 2.5F}};
  FootbotCamera camera;
  camera.blobs = Span<const ColorBlob>(blobs.data(), blobs.size());
  camera.overflowed = true;
  swarmanoid_msgs::ColorBlobs message;
  toMessage(camera, message);
  FootbotCamera back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("footbot_camera", &camera), bytesOf("footbot_camera", &back));
}

TEST(DeviceMessages, KeepThatADistanceIsNotKnown) {
  const ColorBlob blob{{255, 0, 1}, 0.5F, std::numeric_limits<float>::quiet_NaN(), -0.75F, 0.125F};
  HandbotCamera camera;
  camera.blobs = Span<const ColorBlob>(&blob, 1);
  swarmanoid_msgs::ColorBlobs message;
  toMessage(camera, message);
  EXPECT_TRUE(std::isnan(message.blobs[0].distance)) << "REP-117";
  HandbotCamera back;
  VariableParts parts;
  detail::receive(message, back, parts);
  ASSERT_EQ(1U, back.blobs.size());
  EXPECT_TRUE(std::isnan(back.blobs[0].distance));
  EXPECT_EQ(-0.75F, back.blobs[0].elevation);
}

TEST(DeviceMessages, OfFootbotsGroundSayWhereTheSpotsAre) {
  swarmanoid_msgs::GroundArray message;
  toMessage(FootbotGround{}, message);
  ASSERT_EQ(message.x.size(), 8U);
  // spot 5 is at 247.5 degrees
  EXPECT_NEAR(message.x[5], -0.02410906, 1e-7);
  EXPECT_NEAR(message.y[5], -0.05820441, 1e-7);
  EXPECT_EQ("found 8 values, expected 4", (refusalOf(message, FootbotBaseGround{})));
  toMessage(FootbotBaseGround{}, message);
  EXPECT_EQ(message.x, (std::vector<float>{0.03F, -0.03F, -0.03F, 0.03F}));
  EXPECT_EQ(message.y, (std::vector<float>{0.03F, 0.03F, -0.03F, -0.03F}));
  EXPECT_EQ("found 4 values, expected 8", (refusalOf(message, FootbotGround{})));
}

TEST(DeviceMessages, ARefusedListLeavesTheFormerOne) {
  swarmanoid_msgs::ColorBlobs message;
  message.blobs.resize(2);
  message.blobs[1].bearing = 0.75F;
  FootbotCamera camera;
  VariableParts parts;
  detail::receive(message, camera, parts);
  message.blobs.resize(500);
  message.blobs[499].bearing = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(detail::receive(message, camera, parts), std::runtime_error);
  ASSERT_EQ(2U, camera.blobs.size());
  EXPECT_EQ(0.75F, camera.blobs[1].bearing);
}

TEST(DeviceMessages, KeepAllCommands) {
  expectNothingLost<swarmanoid_msgs::WheelsCommand>(FootbotWheels{1.5, -2.5});
  expectNothingLost<swarmanoid_msgs::WheelsCommand>(Wheels{1.5, -2.5});
  expectNothingLost<geometry_msgs::Twist>(DifferentialDrive{0.25, -0.5});
  expectNothingLost<swarmanoid_msgs::GripperCommand>(FootbotGripper{true});
  expectNothingLost<swarmanoid_msgs::TurretCommand>(FootbotTurret{FootbotTurret::Mode::kSpeed, 0.25, -0.5});
  expectNothingLost<swarmanoid_msgs::TurretCommand>(FootbotTurret{FootbotTurret::Mode::kPassive, 0.0, 0.0});
  expectNothingLost<geometry_msgs::Twist>(EyebotVelocity{{0.1, 0.2, 0.3}, 0.4});
  expectNothingLost<swarmanoid_msgs::LaserCommand>(EyebotLaser{true, 0.5, -0.25});
  expectNothingLost<swarmanoid_msgs::PanTiltCommand>(EyebotPanTilt{0.5, -0.25});
  expectNothingLost<swarmanoid_msgs::GripperCommand>(EyebotMagnet{true});
  expectNothingLost<sensor_msgs::JointState>(HandbotArms{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}});
  expectNothingLost<swarmanoid_msgs::HandsCommand>(HandbotHands{true, false});
  expectNothingLost<swarmanoid_msgs::RopeCommand>(HandbotRope{true, -0.25});
  FootbotLeds footbot;
  footbot.ring[3] = {255, 128, 1};
  expectNothingLost<swarmanoid_msgs::LedArray>(footbot);
  EyebotLeds eyebot;
  eyebot.ring[15] = colors::kRed;
  expectNothingLost<swarmanoid_msgs::LedArray>(eyebot);
}

TEST(DeviceMessages, AFootbotIsDrivenByATwistToo) {
  geometry_msgs::Twist twist;
  twist.linear.x = 0.1;
  twist.angular.z = 1.0;
  FootbotWheels wheels;
  fromMessage(twist, wheels);
  // the left wheel runs on a circle that is smaller by half the track
  EXPECT_NEAR((0.1 - 1.0 * 0.07) / 0.029, wheels.left, 1e-12);
  EXPECT_NEAR((0.1 + 1.0 * 0.07) / 0.029, wheels.right, 1e-12);
  geometry_msgs::Twist back;
  toMessage(wheels, back);
  EXPECT_NEAR(0.1, back.linear.x, 1e-12);
  EXPECT_NEAR(1.0, back.angular.z, 1e-12);
}

TEST(DeviceMessages, ArmsKeepWhatIsNotNamed) {
  HandbotArms arms{{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
  sensor_msgs::JointState message;
  message.name = {"right_elbow", "left_wrist"};
  message.position = {-1.0, 1.0};
  fromMessage(message, arms);
  EXPECT_EQ(-1.0, arms.right.elbow);
  EXPECT_EQ(1.0, arms.left.wrist);
  EXPECT_EQ(0.1, arms.left.shoulder);
  EXPECT_EQ(0.6, arms.right.wrist);
}

TEST(DeviceMessages, BadOnesAreRefusedAndChangeNothing) {
  swarmanoid_msgs::ProximityArray proximity;
  proximity.values.resize(8);
  EXPECT_EQ("found 8 values, expected 24", (refusalOf(proximity, FootbotProximity{})));

  geometry_msgs::Twist twist;
  twist.linear.y = 0.5;
  EXPECT_EQ("found linear.y 0.500000, allowed: 0, this robot cannot do it", (refusalOf(twist, FootbotWheels{1, 2})));
  EXPECT_EQ("", (refusalOf(twist, EyebotVelocity{})));
  twist.linear.z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ("found a number that is not finite, allowed: finite numbers", (refusalOf(twist, EyebotVelocity{})));

  swarmanoid_msgs::TurretCommand turret;
  turret.mode = 3;
  EXPECT_EQ("found mode 3, allowed: 0 (ANGLE), 1 (SPEED), 2 (PASSIVE)", (refusalOf(turret, FootbotTurret{})));

  swarmanoid_msgs::LedArray leds;
  leds.colors.resize(16);
  EXPECT_EQ("found 16 colours, expected 12", (refusalOf(leds, FootbotLeds{})));
  EXPECT_EQ("", (refusalOf(leds, EyebotLeds{})));

  sensor_msgs::JointState joints;
  joints.name = {"left_elbow", "left_elbo"};
  joints.position = {1.0};
  EXPECT_EQ("found 1 positions, expected 2, one for each name", (refusalOf(joints, HandbotArms{})));
  joints.position = {1.0, 2.0};
  EXPECT_EQ(
      "found joint 'left_elbo', allowed: left_shoulder, left_elbow, left_wrist, right_shoulder, right_elbow, "
      "right_wrist; did you mean 'left_elbow'?",
      (refusalOf(joints, HandbotArms{})));
  EXPECT_EQ("found 2 joints and at least 0 values, expected joint 'turret' with position, velocity and effort",
            (refusalOf(joints, FootbotTurretState{})));
}

TEST(DeviceMessages, TwoWheelsRefuseEachMotionThatTheyCannotCarryOut) {
  geometry_msgs::Twist left, up, roll, pitch;
  left.linear.y = 0.5;
  up.linear.z = 0.5;
  roll.angular.x = 0.5;
  pitch.angular.y = 0.5;
  const std::pair<const char*, geometry_msgs::Twist> motions[] = {
      {"linear.y", left}, {"linear.z", up}, {"angular.x", roll}, {"angular.y", pitch}};
  for (const auto& [name, twist] : motions) {
    const std::string expected = "found " + std::string(name) + " 0.500000, allowed: 0, this robot cannot do it";
    EXPECT_EQ(expected, (refusalOf(twist, FootbotWheels{1, 2})));
    EXPECT_EQ(expected, (refusalOf(twist, DifferentialDrive{0.1, 0.2})));
  }
}

TEST(DeviceTopics, TheFirstIsTheMainOne) {
  EXPECT_EQ("wheels/command", mainTopicOf("footbot_wheels")->name);
  EXPECT_EQ(2U, topicsOf("footbot_wheels").size());
  EXPECT_EQ("geometry_msgs/Twist", topicsOf("footbot_wheels")[1]->message);
  EXPECT_EQ(nullptr, mainTopicOf("footbot_wings"));
}

}  // namespace
}  // namespace swarmanoid
