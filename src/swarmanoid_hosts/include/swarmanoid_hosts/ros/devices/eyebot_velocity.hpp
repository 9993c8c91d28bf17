/// Defines the topics of devices/eyebot_velocity.hpp, and converts its devices to messages and back.
#pragma once

#include <geometry_msgs/Twist.h>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"

namespace swarmanoid {

inline void toMessage(const EyebotVelocity& command, geometry_msgs::Twist& message) {
  message.linear.x = command.linear.x();
  message.linear.y = command.linear.y();
  message.linear.z = command.linear.z();
  message.angular.z = command.yaw_rate;
}

/// Reads linear and angular.z; angular.x and y must be 0.
inline void fromMessage(const geometry_msgs::Twist& message, EyebotVelocity& command) {
  refuseUnlessZero("angular.x", message.angular.x);
  refuseUnlessZero("angular.y", message.angular.y);
  command.linear = {message.linear.x, message.linear.y, message.linear.z};
  command.yaw_rate = message.angular.z;
}

REGISTER_DEVICE_TOPIC(EyebotVelocity, geometry_msgs::Twist, kCommand, "cmd_vel")

}  // namespace swarmanoid
