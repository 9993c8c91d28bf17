/// Defines the topic of devices/odometry.hpp, and converts its device to messages and back.
#pragma once

#include <nav_msgs/Odometry.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/odometry.hpp"

namespace swarmanoid {

namespace detail {

/// Rows and columns of x, y and heading in the covariance of a pose, which has x, y, z and the turns about these axes.
constexpr std::array<std::size_t, Odometry::kCoordinates> kInPose{0, 1, 5};
constexpr std::size_t kPoseCoordinates = 6;
/// Rows of the twist's covariance whose speeds wheels do not measure: height, roll and pitch.
constexpr std::array<std::size_t, 3> kNotInTwist{2, 3, 4};
/// Variance of the coordinates that wheels do not measure: height, roll and pitch [m2, rad2], and in the twist their
/// rates.
constexpr double kUnknown = 1e6;

}  // namespace detail

/// The pose is in the message's frame, the twist in `child_frame_id`, the robot's base_link. The variances of the twist
/// are 0 for the speeds ahead and sideways and the turn rate, whose errors are not estimated.
inline void toMessage(const Odometry& readings, nav_msgs::Odometry& message) {
  message.pose.pose.position.x = readings.x;
  message.pose.pose.position.y = readings.y;
  message.pose.pose.orientation.z = std::sin(0.5 * readings.heading);
  message.pose.pose.orientation.w = std::cos(0.5 * readings.heading);
  message.twist.twist.linear.x = readings.speed;
  message.twist.twist.angular.z = readings.turn_rate;
  for (std::size_t i = 0; i < detail::kPoseCoordinates; ++i) {
    message.pose.covariance[i * (detail::kPoseCoordinates + 1)] = detail::kUnknown;
  }
  for (const std::size_t i : detail::kNotInTwist) {
    message.twist.covariance[i * (detail::kPoseCoordinates + 1)] = detail::kUnknown;
  }
  for (std::size_t row = 0; row < Odometry::kCoordinates; ++row) {
    for (std::size_t column = 0; column < Odometry::kCoordinates; ++column) {
      message.pose.covariance[detail::kInPose[row] * detail::kPoseCoordinates + detail::kInPose[column]] =
          readings.covariance[row * Odometry::kCoordinates + column];
    }
  }
}

/// Reads a motion on level ground; roll, pitch and sideways speed must be 0.
inline void fromMessage(const nav_msgs::Odometry& message, Odometry& readings) {
  const auto& orientation = message.pose.pose.orientation;
  refuseUnlessZero("pose.orientation.x", orientation.x);
  refuseUnlessZero("pose.orientation.y", orientation.y);
  refuseUnlessForWheels(message.twist.twist);
  readings.x = message.pose.pose.position.x;
  readings.y = message.pose.pose.position.y;
  readings.heading = wrapAngle(2.0 * std::atan2(orientation.z, orientation.w));
  readings.speed = message.twist.twist.linear.x;
  readings.turn_rate = message.twist.twist.angular.z;
  for (std::size_t row = 0; row < Odometry::kCoordinates; ++row) {
    for (std::size_t column = 0; column < Odometry::kCoordinates; ++column) {
      readings.covariance[row * Odometry::kCoordinates + column] =
          message.pose.covariance[detail::kInPose[row] * detail::kPoseCoordinates + detail::kInPose[column]];
    }
  }
}

REGISTER_DEVICE_TOPIC(Odometry, nav_msgs::Odometry, kReading, "odom", "odom")

}  // namespace swarmanoid
