/// Defines the topics of devices/eyebot_pan_tilt.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/PanTiltCommand.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/eyebot_pan_tilt.hpp"

namespace swarmanoid {

inline void toMessage(const EyebotPanTilt& command, swarmanoid_msgs::PanTiltCommand& message) {
  message.pan = command.pan;
  message.tilt = command.tilt;
}

inline void fromMessage(const swarmanoid_msgs::PanTiltCommand& message, EyebotPanTilt& command) {
  command = {message.pan, message.tilt};
}

REGISTER_DEVICE_TOPIC(EyebotPanTilt, swarmanoid_msgs::PanTiltCommand, kCommand, "pan_tilt_camera/command")

}  // namespace swarmanoid
