/// Defines the topics of devices/footbot_proximity.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/ProximityArray.h>

#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"

namespace swarmanoid {

inline void toMessage(const FootbotProximity& readings, swarmanoid_msgs::ProximityArray& message) {
  constexpr std::uint8_t kInfrared = 1;
  message.radiation_type = kInfrared;
  message.angles.resize(FootbotProximity::kCount);
  for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
    message.angles[i] = static_cast<float>(FootbotProximity::angle(i));
  }
  message.values.assign(readings.value.begin(), readings.value.end());
}

inline void fromMessage(const swarmanoid_msgs::ProximityArray& message, FootbotProximity& readings) {
  if (message.values.size() != FootbotProximity::kCount) {
    throw std::runtime_error("found " + std::to_string(message.values.size()) + " values, expected " +
                             std::to_string(FootbotProximity::kCount));
  }
  std::copy(message.values.begin(), message.values.end(), readings.value.begin());
}

REGISTER_DEVICE_TOPIC(FootbotProximity, swarmanoid_msgs::ProximityArray, kReading, "proximity", "base_link")

}  // namespace swarmanoid
