/// Defines the topics of devices/eyebot_laser.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/LaserCommand.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"

namespace swarmanoid {

inline void toMessage(const EyebotLaser& command, swarmanoid_msgs::LaserCommand& message) {
  message.on = command.on;
  message.pan = command.pan;
  message.tilt = command.tilt;
}

inline void fromMessage(const swarmanoid_msgs::LaserCommand& message, EyebotLaser& command) {
  command = {message.on != 0, message.pan, message.tilt};
}

REGISTER_DEVICE_TOPIC(EyebotLaser, swarmanoid_msgs::LaserCommand, kCommand, "laser/command")

}  // namespace swarmanoid
