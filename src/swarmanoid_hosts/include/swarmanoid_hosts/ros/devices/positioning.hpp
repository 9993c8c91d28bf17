/// Defines the topic of devices/positioning.hpp, and converts its device to messages and back.
#pragma once

#include <geometry_msgs/PoseStamped.h>

#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/tf_frames.hpp"
#include "swarmanoid_interface/devices/positioning.hpp"

namespace swarmanoid {

inline void toMessage(const Positioning& readings, geometry_msgs::PoseStamped& message) {
  message.pose.position.x = readings.position.x();
  message.pose.position.y = readings.position.y();
  message.pose.position.z = readings.position.z();
  const Eigen::Quaterniond orientation = readings.orientation();
  message.pose.orientation.x = orientation.x();
  message.pose.orientation.y = orientation.y();
  message.pose.orientation.z = orientation.z();
  message.pose.orientation.w = orientation.w();
}

/// Ignores the frame_id: the frame of the tracking system is the robots' world.
inline void fromMessage(const geometry_msgs::PoseStamped& message, Positioning& readings) {
  const auto& q = message.pose.orientation;
  const Eigen::Quaterniond orientation(q.w, q.x, q.y, q.z);
  constexpr double kAllowed = 0.01;  // error of the length, since drivers may round
  if (!(std::abs(orientation.norm() - 1.0) <= kAllowed)) {
    throw std::runtime_error("found an orientation of the length " + std::to_string(orientation.norm()) +
                             ", allowed: a quaternion of length 1");
  }
  readings = Positioning::reading({message.pose.position.x, message.pose.position.y, message.pose.position.z},
                                  orientation.normalized());
}

REGISTER_DEVICE_TOPIC(Positioning, geometry_msgs::PoseStamped, kReading, "pose", kWorldFrame)

}  // namespace swarmanoid
