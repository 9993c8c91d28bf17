#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "swarmanoid_hosts/ros/devices/positioning.hpp"

namespace swarmanoid {
namespace {

TEST(PositioningMessagesTest, AQuaternionAndBack) {
  const Positioning readings{{1.5, -2.5, 0.25}, 0.3, -1.2, 2.9};
  geometry_msgs::PoseStamped message;
  toMessage(readings, message);
  // by hand: cos and sin of the half angles
  const double cr = std::cos(0.15), sr = std::sin(0.15), cp = std::cos(-0.6), sp = std::sin(-0.6);
  const double cy = std::cos(1.45), sy = std::sin(1.45);
  EXPECT_NEAR(cr * cp * cy + sr * sp * sy, message.pose.orientation.w, 1e-12);
  EXPECT_NEAR(sr * cp * cy - cr * sp * sy, message.pose.orientation.x, 1e-12);
  EXPECT_NEAR(cr * sp * cy + sr * cp * sy, message.pose.orientation.y, 1e-12);
  EXPECT_NEAR(cr * cp * sy - sr * sp * cy, message.pose.orientation.z, 1e-12);
  EXPECT_EQ(-2.5, message.pose.position.y);
  Positioning back;
  fromMessage(message, back);
  EXPECT_EQ(readings.position, back.position);
  EXPECT_NEAR(0.3, back.roll, 1e-12);
  EXPECT_NEAR(-1.2, back.pitch, 1e-12);
  EXPECT_NEAR(2.9, back.heading, 1e-12);
}

TEST(PositioningMessagesTest, WhatIsNoOrientationIsRefused) {
  geometry_msgs::PoseStamped message;
  Positioning readings;
  try {
    fromMessage(message, readings);
    FAIL() << "all of it is 0";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ("found an orientation of the length 0.000000, allowed: a quaternion of length 1", error.what());
  }
  message.pose.orientation.z = std::nan("");
  EXPECT_THROW(fromMessage(message, readings), std::runtime_error);
  message.pose.orientation.z = 1.004;  // rounded by a driver
  fromMessage(message, readings);
  EXPECT_NEAR(M_PI, std::abs(readings.heading), 1e-12);
}

TEST(PositioningMessagesTest, ItsFrameIsThatOfAllRobots) {
  const DeviceTopic& topic = *mainTopicOf("positioning");
  EXPECT_EQ("pose", topic.name);
  EXPECT_EQ("world", frameOf("fb_1", topic.frame));
  EXPECT_EQ("fb_1/base_link", frameOf("fb_1", "base_link"));
}

}  // namespace
}  // namespace swarmanoid
