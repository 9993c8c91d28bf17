/// Defines the topic of devices/loudspeaker.hpp, and converts its device to messages and back.
#pragma once

#include <swarmanoid_msgs/LoudspeakerCommand.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/loudspeaker.hpp"

namespace swarmanoid {

inline void toMessage(const Loudspeaker& command, swarmanoid_msgs::LoudspeakerCommand& message) {
  message.level = command.level;
  message.frequency = command.frequency;
}

inline void fromMessage(const swarmanoid_msgs::LoudspeakerCommand& message, Loudspeaker& command) {
  command = {message.level, message.frequency};
}

REGISTER_DEVICE_TOPIC(Loudspeaker, swarmanoid_msgs::LoudspeakerCommand, kCommand, "loudspeaker/command")

}  // namespace swarmanoid
