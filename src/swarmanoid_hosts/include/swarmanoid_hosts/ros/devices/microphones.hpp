/// Defines the topics of devices/microphones.hpp and devices/footbot_microphones.hpp, and converts their devices to
/// messages and back.
#pragma once

#include <swarmanoid_msgs/MicrophoneLevels.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/same_length.hpp"
#include "swarmanoid_interface/devices/footbot_microphones.hpp"
#include "swarmanoid_interface/devices/microphones.hpp"

namespace swarmanoid {

inline void toMessage(const LoudestSound& loudest, swarmanoid_msgs::MicrophoneLevels& message) {
  message.bearing = loudest.bearing;
  message.confidence = loudest.confidence;
  message.frequency = loudest.frequency;
}

inline void toMessage(const Microphones& readings, swarmanoid_msgs::MicrophoneLevels& message) {
  const std::size_t count = readings.sensors.size();
  message.x.resize(count);
  message.y.resize(count);
  message.levels.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    message.x[i] = readings.sensors[i].x;
    message.y[i] = readings.sensors[i].y;
    message.levels[i] = readings.sensors[i].level;
  }
  toMessage(readings.loudest, message);
}

inline void toMessage(const FootbotMicrophones& readings, swarmanoid_msgs::MicrophoneLevels& message) {
  message.x.resize(FootbotMicrophones::kCount);
  message.y.resize(FootbotMicrophones::kCount);
  for (std::size_t i = 0; i < FootbotMicrophones::kCount; ++i) {
    message.x[i] = static_cast<float>(FootbotMicrophones::place(i).x());
    message.y[i] = static_cast<float>(FootbotMicrophones::place(i).y());
  }
  message.levels.assign(readings.level.begin(), readings.level.end());
  toMessage(readings.loudest, message);
}

/// The readings are stored in `parts`.
inline void fromMessage(const swarmanoid_msgs::MicrophoneLevels& message, Microphones& readings, VariableParts& parts) {
  const std::size_t count = sameLength(
      {{"x", message.x.size()}, {"y", message.y.size()}, {"levels", message.levels.size()}}, Microphones::kMost);
  parts.clear();
  Microphone* microphones = parts.room<Microphone>(count);
  for (std::size_t i = 0; i < count; ++i) {
    microphones[i] = {message.levels[i], message.x[i], message.y[i]};
  }
  readings.sensors = Span<const Microphone>(microphones, count);
  readings.loudest = {message.bearing, message.confidence, message.frequency};
}

inline void fromMessage(const swarmanoid_msgs::MicrophoneLevels& message, FootbotMicrophones& readings) {
  if (message.levels.size() != FootbotMicrophones::kCount) {
    throw std::runtime_error("found " + std::to_string(message.levels.size()) + " levels, expected " +
                             std::to_string(FootbotMicrophones::kCount));
  }
  std::copy(message.levels.begin(), message.levels.end(), readings.level.begin());
  readings.loudest = {message.bearing, message.confidence, message.frequency};
}

REGISTER_DEVICE_TOPIC(Microphones, swarmanoid_msgs::MicrophoneLevels, kReading, "microphones", "base_link")
REGISTER_DEVICE_TOPIC(FootbotMicrophones, swarmanoid_msgs::MicrophoneLevels, kReading, "microphones", "base_link")

}  // namespace swarmanoid
