/// Defines the topic of devices/ground.hpp, and converts its device to messages and back.
#pragma once

#include <swarmanoid_msgs/GroundArray.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/same_length.hpp"
#include "swarmanoid_interface/devices/ground.hpp"

namespace swarmanoid {

inline void toMessage(const Ground& readings, swarmanoid_msgs::GroundArray& message) {
  message.x.resize(readings.sensors.size());
  message.y.resize(readings.sensors.size());
  message.values.resize(readings.sensors.size());
  for (std::size_t i = 0; i < readings.sensors.size(); ++i) {
    message.x[i] = readings.sensors[i].x;
    message.y[i] = readings.sensors[i].y;
    message.values[i] = readings.sensors[i].value;
  }
}

/// The readings are stored in `parts`.
inline void fromMessage(const swarmanoid_msgs::GroundArray& message, Ground& readings, VariableParts& parts) {
  const std::size_t count = sameLength(
      {{"x", message.x.size()}, {"y", message.y.size()}, {"values", message.values.size()}}, Ground::kMostSpots);
  parts.clear();
  GroundSpot* spots = parts.room<GroundSpot>(count);
  for (std::size_t i = 0; i < count; ++i) {
    spots[i] = {message.values[i], message.x[i], message.y[i]};
  }
  readings.sensors = Span<const GroundSpot>(spots, count);
}

REGISTER_DEVICE_TOPIC(Ground, swarmanoid_msgs::GroundArray, kReading, "ground", "base_link")

}  // namespace swarmanoid
