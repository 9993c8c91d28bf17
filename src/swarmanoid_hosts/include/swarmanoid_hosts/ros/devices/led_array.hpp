/// Defines the topic of devices/led_array.hpp, and converts its device to messages and back.
#pragma once

#include <swarmanoid_msgs/LedArray.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/led_array.hpp"

namespace swarmanoid {

inline void toMessage(const Leds& command, swarmanoid_msgs::LedArray& message) {
  toMessage(Span<const Color>(command.colors.data(), command.colors.size()), message);
}

/// LEDs without a colour in the message are off.
inline void fromMessage(const swarmanoid_msgs::LedArray& message, Leds& command) {
  const std::size_t count = message.colors.size();
  if (count > Leds::kMost) {
    throw std::runtime_error("found " + std::to_string(count) + " colours, allowed: at most " +
                             std::to_string(Leds::kMost));
  }
  command.setAll(colors::kBlack);
  fromMessage(message, Span<Color>(command.colors.data(), count));
}

REGISTER_DEVICE_TOPIC(Leds, swarmanoid_msgs::LedArray, kCommand, "leds/command")

}  // namespace swarmanoid
