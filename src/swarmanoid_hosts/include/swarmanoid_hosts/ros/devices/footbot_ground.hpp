/// Defines the topics of devices/footbot_ground.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/GroundArray.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"

namespace swarmanoid {
namespace detail {

/// @tparam Spots a device with `value` and `place`
template <class Spots>
void toGroundArray(const Spots& readings, swarmanoid_msgs::GroundArray& message) {
  message.x.resize(Spots::kCount);
  message.y.resize(Spots::kCount);
  for (std::size_t i = 0; i < Spots::kCount; ++i) {
    const Eigen::Vector2d place = Spots::place(i);
    message.x[i] = static_cast<float>(place.x());
    message.y[i] = static_cast<float>(place.y());
  }
  message.values.assign(readings.value.begin(), readings.value.end());
}

/// Reads the values only, since the positions of the spots are fixed.
template <class Spots>
void fromGroundArray(const swarmanoid_msgs::GroundArray& message, Spots& readings) {
  if (message.values.size() != Spots::kCount) {
    throw std::runtime_error("found " + std::to_string(message.values.size()) + " values, expected " +
                             std::to_string(Spots::kCount));
  }
  std::copy(message.values.begin(), message.values.end(), readings.value.begin());
}

}  // namespace detail

inline void toMessage(const FootbotGround& readings, swarmanoid_msgs::GroundArray& message) {
  detail::toGroundArray(readings, message);
}
inline void fromMessage(const swarmanoid_msgs::GroundArray& message, FootbotGround& readings) {
  detail::fromGroundArray(message, readings);
}
REGISTER_DEVICE_TOPIC(FootbotGround, swarmanoid_msgs::GroundArray, kReading, "ground", "base_link")

inline void toMessage(const FootbotBaseGround& readings, swarmanoid_msgs::GroundArray& message) {
  detail::toGroundArray(readings, message);
}
inline void fromMessage(const swarmanoid_msgs::GroundArray& message, FootbotBaseGround& readings) {
  detail::fromGroundArray(message, readings);
}
REGISTER_DEVICE_TOPIC(FootbotBaseGround, swarmanoid_msgs::GroundArray, kReading, "base_ground", "base_link")

}  // namespace swarmanoid
