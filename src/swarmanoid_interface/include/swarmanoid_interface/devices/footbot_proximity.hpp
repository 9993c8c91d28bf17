/// Sensor: the ring of infrared proximity sensors around a footbot (thesis figure 1.1b).
#pragma once

#include <array>
#include <cstddef>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/ring.hpp"

namespace swarmanoid {

/// Readings of the 24 sensors: 0 with nothing in range, rising to 1 at contact, by the law of Proximity::response
/// unless the experiment selects another implementation. Sensor 0 looks straight ahead (the robot's x axis), the others
/// follow counter-clockwise every 15 degrees.
struct FootbotProximity {
  static constexpr const char* kType = "footbot_proximity";
  static constexpr const char* kRobot = "footbot";
  static constexpr std::size_t kCount = 24;
  static constexpr double kRingRadius = 0.085;  ///< of the sensors around the robot's axis [m]

  std::array<float, kCount> value{};

  /// Direction of sensor `i` in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi].
  static constexpr double angle(std::size_t i) { return ringAngle(i, kCount); }
};

template <class Visitor>
void fields(Visitor& visit, FootbotProximity& proximity) {
  visit(proximity.value, {"value", "", "0 without an object in range, 1 at contact", {0.0, 1.0}});
}
REGISTER_DEVICE_OF_SUITE(FootbotProximity, kSensor, "24 infrared sensors around the body.")

}  // namespace swarmanoid
