/// Defines the topic of devices/differential_drive.hpp, and converts its device to messages and back.
#pragma once

#include <geometry_msgs/Twist.h>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"

namespace swarmanoid {

inline void toMessage(const DifferentialDrive& command, geometry_msgs::Twist& message) {
  message.linear.x = command.speed;
  message.angular.z = command.turn_rate;
}

/// Reads linear.x and angular.z; the others must be 0, since two wheels cannot carry them out.
inline void fromMessage(const geometry_msgs::Twist& message, DifferentialDrive& command) {
  refuseUnlessForWheels(message);
  command.drive(message.linear.x, message.angular.z);
}

REGISTER_DEVICE_TOPIC(DifferentialDrive, geometry_msgs::Twist, kCommand, "cmd_vel")

}  // namespace swarmanoid
