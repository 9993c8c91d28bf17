/// Defines the topics of devices/leds.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/LedArray.h>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid {

inline void toMessage(const FootbotLeds& command, swarmanoid_msgs::LedArray& message) {
  toMessage(Span<const Color>(command.ring.data(), command.ring.size()), message);
}

inline void fromMessage(const swarmanoid_msgs::LedArray& message, FootbotLeds& command) {
  fromMessage(message, Span<Color>(command.ring.data(), command.ring.size()));
}

inline void toMessage(const EyebotLeds& command, swarmanoid_msgs::LedArray& message) {
  toMessage(Span<const Color>(command.ring.data(), command.ring.size()), message);
}

inline void fromMessage(const swarmanoid_msgs::LedArray& message, EyebotLeds& command) {
  fromMessage(message, Span<Color>(command.ring.data(), command.ring.size()));
}

REGISTER_DEVICE_TOPIC(FootbotLeds, swarmanoid_msgs::LedArray, kCommand, "leds/command")
REGISTER_DEVICE_TOPIC(EyebotLeds, swarmanoid_msgs::LedArray, kCommand, "leds/command")

}  // namespace swarmanoid
