/// Defines the topics of devices/distance.hpp, devices/eyebot_distance.hpp and devices/handbot_distance.hpp, and
/// converts their devices to messages and back.
#pragma once

#include <sensor_msgs/Range.h>
#include <swarmanoid_msgs/RangeArray.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/same_length.hpp"
#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_interface/devices/eyebot_distance.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"

namespace swarmanoid {
namespace distance_messages {

/// Resizes the lists for the sensors of a device, and sets their measuring range.
template <class Device>
void start(const Device& device, std::size_t count, swarmanoid_msgs::RangeArray& message) {
  message.radiation_type = sensor_msgs::Range::INFRARED;
  message.min_range = device.range_min;
  message.max_range = device.range_max;
  message.angles.assign(count, 0.0F);
  message.elevations.assign(count, 0.0F);
  message.ranges.resize(count);
}

template <class Device>
void readRange(const swarmanoid_msgs::RangeArray& message, Device& device) {
  device.range_min = message.min_range;
  device.range_max = message.max_range;
}

/// Reads a device with a fixed number of sensors, whose angles are known. @throws std::runtime_error
template <class Device>
void readFixed(const swarmanoid_msgs::RangeArray& message, Device& device) {
  if (message.ranges.size() != Device::kCount) {
    throw std::runtime_error("found " + std::to_string(message.ranges.size()) +
                             " ranges, allowed: " + std::to_string(Device::kCount));
  }
  readRange(message, device);
  for (std::size_t i = 0; i < Device::kCount; ++i) {
    device.value(i) = message.ranges[i];
  }
}

}  // namespace distance_messages

inline void toMessage(const Distance& readings, swarmanoid_msgs::RangeArray& message) {
  distance_messages::start(readings, readings.sensors.size(), message);
  for (std::size_t i = 0; i < readings.sensors.size(); ++i) {
    message.angles[i] = readings.sensors[i].angle;
    message.elevations[i] = readings.sensors[i].elevation;
    message.ranges[i] = readings.sensors[i].distance;
  }
}

/// The readings are stored in `parts`.
inline void fromMessage(const swarmanoid_msgs::RangeArray& message, Distance& readings, VariableParts& parts) {
  const std::size_t count = sameLength(
      {{"angles", message.angles.size()}, {"elevations", message.elevations.size()}, {"ranges", message.ranges.size()}},
      Distance::kMostSensors);
  distance_messages::readRange(message, readings);
  parts.clear();
  auto* sensors = parts.room<DistanceReading>(count);
  for (std::size_t i = 0; i < count; ++i) {
    sensors[i] = {message.ranges[i], message.angles[i], message.elevations[i]};
  }
  readings.sensors = Span<const DistanceReading>(sensors, count);
}

inline void toMessage(const EyebotDistance& readings, swarmanoid_msgs::RangeArray& message) {
  distance_messages::start(readings, EyebotDistance::kCount, message);
  for (std::size_t i = 0; i < EyebotDistance::kCount; ++i) {
    message.ranges[i] = readings.value(i);
  }
  for (std::size_t i = 0; i < EyebotDistance::kAround; ++i) {
    message.angles[i] = static_cast<float>(EyebotDistance::angle(i));
  }
  message.elevations[EyebotDistance::kAround] = static_cast<float>(M_PI / 2.0);
  message.elevations[EyebotDistance::kAround + 1] = static_cast<float>(-M_PI / 2.0);
}

inline void fromMessage(const swarmanoid_msgs::RangeArray& message, EyebotDistance& readings) {
  distance_messages::readFixed(message, readings);
}

inline void toMessage(const HandbotDistance& readings, swarmanoid_msgs::RangeArray& message) {
  distance_messages::start(readings, HandbotDistance::kCount, message);
  for (std::size_t i = 0; i < HandbotDistance::kCount; ++i) {
    message.ranges[i] = readings.value(i);
    message.angles[i] = static_cast<float>(HandbotDistance::angle(i));
  }
}

inline void fromMessage(const swarmanoid_msgs::RangeArray& message, HandbotDistance& readings) {
  distance_messages::readFixed(message, readings);
}

REGISTER_DEVICE_TOPIC(Distance, swarmanoid_msgs::RangeArray, kReading, "distance", "base_link")
REGISTER_DEVICE_TOPIC(EyebotDistance, swarmanoid_msgs::RangeArray, kReading, "distance", "base_link")
REGISTER_DEVICE_TOPIC(HandbotDistance, swarmanoid_msgs::RangeArray, kReading, "distance", "base_link")

}  // namespace swarmanoid
