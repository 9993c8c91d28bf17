/// Defines the topics of devices/footbot_wheels.hpp, and converts its devices to messages and back.
#pragma once

#include <geometry_msgs/Twist.h>
#include <swarmanoid_msgs/WheelsCommand.h>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid {

inline void toMessage(const FootbotWheels& command, swarmanoid_msgs::WheelsCommand& message) {
  message.left = command.left;
  message.right = command.right;
}

inline void fromMessage(const swarmanoid_msgs::WheelsCommand& message, FootbotWheels& command) {
  command.setAngularVelocity(message.left, message.right);
}

/// The message contains speed ahead and turn rate.
inline void toMessage(const FootbotWheels& command, geometry_msgs::Twist& message) {
  message.linear.x = command.speed();
  message.angular.z = command.turnRate();
}

/// Reads linear.x and angular.z; the others must be 0, since a footbot cannot carry them out.
inline void fromMessage(const geometry_msgs::Twist& message, FootbotWheels& command) {
  refuseUnlessForWheels(message);
  command.drive(message.linear.x, message.angular.z);
}

REGISTER_DEVICE_TOPIC(FootbotWheels, swarmanoid_msgs::WheelsCommand, kCommand, "wheels/command")
REGISTER_DEVICE_TOPIC(FootbotWheels, geometry_msgs::Twist, kCommand, "cmd_vel")

}  // namespace swarmanoid
