/// Defines the topic of devices/eyebot_altitude.hpp, and converts its device to messages and back.
#pragma once

#include <sensor_msgs/Range.h>

#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/eyebot_altitude.hpp"

namespace swarmanoid {

/// By REP-117, in the device and in the message: -infinity for too close, +infinity for too far.
inline void toMessage(const EyebotAltitude& readings, sensor_msgs::Range& message) {
  message.radiation_type = sensor_msgs::Range::ULTRASOUND;
  message.field_of_view = 0.0F;  // one ray
  message.min_range = readings.range_min;
  message.max_range = readings.range_max;
  message.range = readings.distance;
}

inline void fromMessage(const sensor_msgs::Range& message, EyebotAltitude& readings) {
  if (!(message.min_range <= message.max_range)) {
    throw std::runtime_error("found min_range " + std::to_string(message.min_range) + " and max_range " +
                             std::to_string(message.max_range) + ", allowed: the first not above the second");
  }
  readings.range_min = message.min_range;
  readings.range_max = message.max_range;
  readings.distance = message.range;
}

REGISTER_DEVICE_TOPIC(EyebotAltitude, sensor_msgs::Range, kReading, "altitude", "altimeter")

}  // namespace swarmanoid
