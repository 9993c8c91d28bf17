/// Defines the topics of devices/eyebot_magnet.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/GripperCommand.h>
#include <swarmanoid_msgs/GripperState.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"

namespace swarmanoid {

inline void toMessage(const EyebotMagnet& command, swarmanoid_msgs::GripperCommand& message) {
  message.closed = command.on;
}

inline void fromMessage(const swarmanoid_msgs::GripperCommand& message, EyebotMagnet& command) {
  command.on = message.closed != 0;
}

inline void toMessage(const EyebotMagnetState& readings, swarmanoid_msgs::GripperState& message) {
  message.gripping = readings.attached;
}

inline void fromMessage(const swarmanoid_msgs::GripperState& message, EyebotMagnetState& readings) {
  readings.attached = message.gripping != 0;
}

REGISTER_DEVICE_TOPIC(EyebotMagnet, swarmanoid_msgs::GripperCommand, kCommand, "magnet/command")
REGISTER_DEVICE_TOPIC(EyebotMagnetState, swarmanoid_msgs::GripperState, kReading, "magnet/state", "magnet")

}  // namespace swarmanoid
