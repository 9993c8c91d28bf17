/// Defines the topic of devices/eyebot_pressure.hpp, and converts its device to messages and back.
#pragma once

#include <sensor_msgs/FluidPressure.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/eyebot_pressure.hpp"

namespace swarmanoid {

/// The message has absolute pressures: that at the start is taken as EyebotPressure::kPressure. The variance is 0
/// (unknown).
inline void toMessage(const EyebotPressure& readings, sensor_msgs::FluidPressure& message) {
  message.fluid_pressure = EyebotPressure::kPressure + readings.difference;
}

inline void fromMessage(const sensor_msgs::FluidPressure& message, EyebotPressure& readings) {
  readings.difference = message.fluid_pressure - EyebotPressure::kPressure;
}

REGISTER_DEVICE_TOPIC(EyebotPressure, sensor_msgs::FluidPressure, kReading, "pressure", "base_link")

}  // namespace swarmanoid
