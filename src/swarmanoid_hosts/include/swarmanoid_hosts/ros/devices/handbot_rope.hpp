/// Defines the topics of devices/handbot_rope.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/RopeCommand.h>
#include <swarmanoid_msgs/RopeState.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid {

inline void toMessage(const HandbotRope& command, swarmanoid_msgs::RopeCommand& message) {
  message.shot = command.shot;
  message.winding_speed = command.winding_speed;
}

inline void fromMessage(const swarmanoid_msgs::RopeCommand& message, HandbotRope& command) {
  command = {message.shot != 0, message.winding_speed};
}

inline void toMessage(const HandbotRopeState& readings, swarmanoid_msgs::RopeState& message) {
  message.attached = readings.attached;
  message.length = readings.length;
  message.tension = readings.tension;
}

inline void fromMessage(const swarmanoid_msgs::RopeState& message, HandbotRopeState& readings) {
  readings = {message.attached != 0, message.length, message.tension};
}

REGISTER_DEVICE_TOPIC(HandbotRope, swarmanoid_msgs::RopeCommand, kCommand, "rope/command")
REGISTER_DEVICE_TOPIC(HandbotRopeState, swarmanoid_msgs::RopeState, kReading, "rope/state", "rope_launcher")

}  // namespace swarmanoid
