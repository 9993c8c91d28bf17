/// Defines the topic of devices/proximity.hpp, and converts its device to messages and back.
#pragma once

#include <swarmanoid_msgs/ProximityArray.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/same_length.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"

namespace swarmanoid {

inline void toMessage(const Proximity& readings, swarmanoid_msgs::ProximityArray& message) {
  constexpr std::uint8_t kInfrared = 1;
  message.radiation_type = kInfrared;
  message.angles.resize(readings.sensors.size());
  message.values.resize(readings.sensors.size());
  for (std::size_t i = 0; i < readings.sensors.size(); ++i) {
    message.angles[i] = readings.sensors[i].angle;
    message.values[i] = readings.sensors[i].value;
  }
}

/// The readings are stored in `parts`.
inline void fromMessage(const swarmanoid_msgs::ProximityArray& message, Proximity& readings, VariableParts& parts) {
  const std::size_t count =
      sameLength({{"angles", message.angles.size()}, {"values", message.values.size()}}, Proximity::kMostSensors);
  parts.clear();
  ProximityReading* sensors = parts.room<ProximityReading>(count);
  for (std::size_t i = 0; i < count; ++i) {
    sensors[i] = {message.values[i], message.angles[i]};
  }
  readings.sensors = Span<const ProximityReading>(sensors, count);
}

REGISTER_DEVICE_TOPIC(Proximity, swarmanoid_msgs::ProximityArray, kReading, "proximity", "base_link")

}  // namespace swarmanoid
