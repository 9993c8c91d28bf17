/// Defines the topic of devices/floor_color.hpp, and converts its device to messages and back.
#pragma once

#include <swarmanoid_msgs/FloorColor.h>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/floor_color.hpp"

namespace swarmanoid {

inline void toMessage(const FloorColor& readings, swarmanoid_msgs::FloorColor& message) {
  message.color = toMessage(readings.color);
}

inline void fromMessage(const swarmanoid_msgs::FloorColor& message, FloorColor& readings) {
  readings.color = fromMessage(message.color);
}

REGISTER_DEVICE_TOPIC(FloorColor, swarmanoid_msgs::FloorColor, kReading, "floor_color", "base_link")

}  // namespace swarmanoid
