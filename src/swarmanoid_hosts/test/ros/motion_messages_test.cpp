// Converts devices that measure motion, and flight to positions, to messages and back.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "message_bench.hpp"
#include "swarmanoid_hosts/ros/devices/eyebot_altitude.hpp"
#include "swarmanoid_hosts/ros/devices/eyebot_position.hpp"
#include "swarmanoid_hosts/ros/devices/eyebot_pressure.hpp"
#include "swarmanoid_hosts/ros/devices/imu.hpp"
#include "swarmanoid_hosts/ros/devices/odometry.hpp"
#include "swarmanoid_hosts/ros/devices/wheel_encoders.hpp"

namespace swarmanoid {
namespace {

using test::expectNothingLost;
using test::refusalOf;
using test::thereAndBack;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(MotionMessages, KeepWhatWheelsTurn) {
  WheelEncoders encoders;
  encoders.left = {1.5, 0.25, 2.5};
  encoders.right = {-3.5, -0.125, -1.25};
  expectNothingLost<swarmanoid_msgs::WheelEncoders>(encoders);
}

TEST(MotionMessages, OfInertialUnitsSayWhatIsNotMeasured) {
  Imu imu;
  imu.angular_velocity = {0.1, -0.2, 0.3};
  imu.linear_acceleration = {-1.5, 2.5, 9.0};
  expectNothingLost<sensor_msgs::Imu>(imu);
  sensor_msgs::Imu message;
  toMessage(imu, message);
  EXPECT_EQ(-1.0, message.orientation_covariance[0]);
  EXPECT_EQ(0.3, message.angular_velocity.z);
  EXPECT_EQ(2.5, message.linear_acceleration.y);
  message.orientation_covariance[0] = 0.01;
  EXPECT_EQ("", refusalOf(message, imu)) << "one that measures it too";
}

TEST(MotionMessages, OfInertialUnitsWithoutAccelerometersAreRefused) {
  sensor_msgs::Imu message;
  message.linear_acceleration_covariance[0] = -1.0;
  EXPECT_EQ("found linear_acceleration_covariance[0] = -1 (not measured), allowed: 0 or more",
            refusalOf(message, Imu{}));
}

TEST(MotionMessages, KeepOdometry) {
  Odometry odometry;
  odometry.x = 1.25;
  odometry.y = -0.7;
  odometry.heading = -2.3;
  odometry.speed = 0.11;
  odometry.turn_rate = -0.9;
  odometry.covariance = {1.0, 0.1, 0.2, 0.1, 2.0, 0.3, 0.2, 0.3, 3.0};
  nav_msgs::Odometry message;
  toMessage(odometry, message);
  EXPECT_EQ(1.25, message.pose.pose.position.x);
  EXPECT_NEAR(std::sin(-1.15), message.pose.pose.orientation.z, 1e-12);
  EXPECT_EQ(0.1, message.pose.covariance[1]) << "of x and y";
  EXPECT_EQ(0.2, message.pose.covariance[5]) << "of x and yaw";
  EXPECT_EQ(0.3, message.pose.covariance[31]) << "of yaw and y";
  EXPECT_EQ(3.0, message.pose.covariance[35]);
  EXPECT_EQ(1e6, message.pose.covariance[14]) << "wheels know nothing of the height";
  EXPECT_EQ(0.0, message.pose.covariance[2]);
  for (const std::size_t of_nothing : {14U, 21U, 28U}) {
    EXPECT_EQ(1e6, message.twist.covariance[of_nothing]) << "nor of climbing, rolling and pitching";
  }
  for (const std::size_t of_wheels : {0U, 7U, 35U}) {
    EXPECT_EQ(0.0, message.twist.covariance[of_wheels]) << "ahead, sideways, turning";
  }
  const Odometry back = thereAndBack<nav_msgs::Odometry>(odometry);
  EXPECT_EQ(odometry.x, back.x);
  EXPECT_EQ(odometry.y, back.y);
  EXPECT_NEAR(odometry.heading, back.heading, 1e-12);
  EXPECT_EQ(odometry.speed, back.speed);
  EXPECT_EQ(odometry.turn_rate, back.turn_rate);
  EXPECT_EQ(odometry.covariance, back.covariance);
  message.twist.twist.linear.y = 0.1;
  EXPECT_NE("", refusalOf(message, odometry)) << "wheels do not go sideways";
}

TEST(MotionMessages, OfOdometryNameTheFrameThatMoves) {
  nav_msgs::Odometry message;
  std_msgs::Header header;
  header.frame_id = "fb_1/odom";
  detail::setFrames(message, header);
  EXPECT_EQ("fb_1/odom", message.header.frame_id);
  EXPECT_EQ("fb_1/base_link", message.child_frame_id);
  EXPECT_EQ("odom", mainTopicOf("odometry")->frame);
}

TEST(MotionMessages, OfAltitudesHaveInfinitiesWhereNothingIsMeasured) {
  EyebotAltitude altitude;
  altitude.range_min = 0.125F;
  altitude.range_max = 2.5F;
  for (const float distance : {1.75F, kInfinity, -kInfinity}) {
    altitude.distance = distance;
    sensor_msgs::Range message;
    toMessage(altitude, message);
    EXPECT_EQ(distance, message.range);
    EXPECT_EQ(0.125F, message.min_range);
    EXPECT_EQ(2.5F, message.max_range);
    expectNothingLost<sensor_msgs::Range>(altitude);
  }
  sensor_msgs::Range message;
  message.min_range = 3.0F;
  message.max_range = 2.5F;
  EXPECT_EQ("found min_range 3.000000 and max_range 2.500000, allowed: the first not above the second",
            refusalOf(message, altitude));
}

TEST(MotionMessages, OfPressureAreAbsolute) {
  EyebotPressure pressure;
  pressure.difference = -12.5;
  expectNothingLost<sensor_msgs::FluidPressure>(pressure);
  sensor_msgs::FluidPressure message;
  toMessage(pressure, message);
  EXPECT_EQ(101312.5, message.fluid_pressure);
}

TEST(MotionMessages, KeepWhereAnEyebotFlies) {
  EyebotPosition command;
  command.goTo({1.5, -2.5, 0.75}, -0.4);
  expectNothingLost<swarmanoid_msgs::FlightCommand>(command);
  swarmanoid_msgs::FlightCommand message;
  message.mode = 4;
  EXPECT_EQ("found mode 4, allowed: 0 (HOVER), 1 (TAKE_OFF), 2 (GO_TO), 3 (LAND)", refusalOf(message, command));
}

TEST(MotionMessages, OfPosesAreGoneTo) {
  EyebotPosition command;
  command.goTo({1.5, -2.5, 0.75}, -2.4);
  const EyebotPosition back = thereAndBack<geometry_msgs::PoseStamped>(command);
  EXPECT_EQ(EyebotPosition::Mode::kGoTo, back.mode);
  EXPECT_EQ(command.position, back.position);
  EXPECT_NEAR(command.yaw, back.yaw, 1e-12);
  geometry_msgs::PoseStamped message;
  EXPECT_EQ("found an orientation of length 0, allowed: a turn about z, such as w = 1 for none",
            refusalOf(message, command));
  message.pose.orientation.w = 1.0;
  message.header.frame_id = "eb/takeoff";
  EXPECT_EQ("", refusalOf(message, command));
  message.header.frame_id = "world";
  EXPECT_EQ("found the frame 'world', allowed: none, or that of the take-off, 'takeoff'", refusalOf(message, command));
  message.header.frame_id = "";
  message.pose.orientation.x = 0.1;
  EXPECT_NE("", refusalOf(message, command)) << "it cannot lean as it likes";
}

}  // namespace
}  // namespace swarmanoid
