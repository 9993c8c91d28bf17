/// Defines the topic of devices/light.hpp, and converts its device to messages and back.
#pragma once

#include <swarmanoid_msgs/LightArray.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/same_length.hpp"
#include "swarmanoid_interface/devices/light.hpp"

namespace swarmanoid {

inline void toMessage(const Light& readings, swarmanoid_msgs::LightArray& message) {
  message.angles.resize(readings.sensors.size());
  message.values.resize(readings.sensors.size());
  for (std::size_t i = 0; i < readings.sensors.size(); ++i) {
    message.angles[i] = readings.sensors[i].angle;
    message.values[i] = readings.sensors[i].value;
  }
}

/// The readings are stored in `parts`.
inline void fromMessage(const swarmanoid_msgs::LightArray& message, Light& readings, VariableParts& parts) {
  const std::size_t count =
      sameLength({{"angles", message.angles.size()}, {"values", message.values.size()}}, Light::kMostSensors);
  parts.clear();
  LightReading* sensors = parts.room<LightReading>(count);
  for (std::size_t i = 0; i < count; ++i) {
    sensors[i] = {message.values[i], message.angles[i]};
  }
  readings.sensors = Span<const LightReading>(sensors, count);
}

REGISTER_DEVICE_TOPIC(Light, swarmanoid_msgs::LightArray, kReading, "light", "base_link")

}  // namespace swarmanoid
