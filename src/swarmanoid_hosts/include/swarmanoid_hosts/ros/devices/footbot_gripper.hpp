/// Defines the topics of devices/footbot_gripper.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/GripperCommand.h>
#include <swarmanoid_msgs/GripperState.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"

namespace swarmanoid {

inline void toMessage(const FootbotGripper& command, swarmanoid_msgs::GripperCommand& message) {
  message.closed = command.closed;
}

inline void fromMessage(const swarmanoid_msgs::GripperCommand& message, FootbotGripper& command) {
  command.closed = message.closed != 0;
}

inline void toMessage(const FootbotGripperState& readings, swarmanoid_msgs::GripperState& message) {
  message.gripping = readings.gripping;
}

inline void fromMessage(const swarmanoid_msgs::GripperState& message, FootbotGripperState& readings) {
  readings.gripping = message.gripping != 0;
}

REGISTER_DEVICE_TOPIC(FootbotGripper, swarmanoid_msgs::GripperCommand, kCommand, "gripper/command")
REGISTER_DEVICE_TOPIC(FootbotGripperState, swarmanoid_msgs::GripperState, kReading, "gripper/state", "gripper_tip")

}  // namespace swarmanoid
