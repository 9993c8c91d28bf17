/// Defines the topic of devices/handbot_leds.hpp, and converts its device to messages and back.
#pragma once

#include <swarmanoid_msgs/LedArray.h>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/handbot_leds.hpp"

namespace swarmanoid {

inline void toMessage(const HandbotLeds& command, swarmanoid_msgs::LedArray& message) {
  toMessage(Span<const Color>(command.ring.data(), command.ring.size()), message);
}

inline void fromMessage(const swarmanoid_msgs::LedArray& message, HandbotLeds& command) {
  fromMessage(message, Span<Color>(command.ring.data(), command.ring.size()));
}

REGISTER_DEVICE_TOPIC(HandbotLeds, swarmanoid_msgs::LedArray, kCommand, "leds/command")

}  // namespace swarmanoid
