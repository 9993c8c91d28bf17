/// Defines the topic of devices/wheels.hpp, and converts its device to messages and back.
#pragma once

#include <swarmanoid_msgs/WheelsCommand.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/wheels.hpp"

namespace swarmanoid {

inline void toMessage(const Wheels& command, swarmanoid_msgs::WheelsCommand& message) {
  message.left = command.left;
  message.right = command.right;
}

inline void fromMessage(const swarmanoid_msgs::WheelsCommand& message, Wheels& command) {
  command.setAngularVelocity(message.left, message.right);
}

REGISTER_DEVICE_TOPIC(Wheels, swarmanoid_msgs::WheelsCommand, kCommand, "wheels/command")

}  // namespace swarmanoid
