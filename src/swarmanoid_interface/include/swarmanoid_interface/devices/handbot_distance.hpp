/// Sensor: the ring of infrared distance sensors around a handbot.
#pragma once

#include <array>
#include <cstddef>

#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_interface/devices/ring.hpp"

namespace swarmanoid {

/// Readings of the 12 sensors by the law of Distance::reading [m]. Sensor 0 looks straight ahead (the robot's x axis),
/// the others follow counter-clockwise every 30 degrees.
struct HandbotDistance {
  static constexpr const char* kType = "handbot_distance";
  static constexpr const char* kRobot = "handbot";
  static constexpr std::size_t kCount = 12;
  static constexpr double kRingRadius = 0.145;  ///< of the sensors around the robot's axis [m]
  /// Measuring range of a Sharp GP2Y0A41SK0F (data sheet OP13008EN: 4 to 30 cm) [m].
  static constexpr Range kUsualRange{0.04, 0.3};

  std::array<float, kCount> distance = unmeasuredDistances<kCount>();
  float range_min = static_cast<float>(kUsualRange.minimum);  ///< nearer objects are too close [m]
  float range_max = static_cast<float>(kUsualRange.maximum);  ///< farther objects are out of range [m]

  /// Direction of sensor `i` in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi].
  static constexpr double angle(std::size_t i) { return ringAngle(i, kCount); }
  float& value(std::size_t i) { return distance[i]; }
  float value(std::size_t i) const { return distance[i]; }
};

template <class Visitor>
void fields(Visitor& visit, HandbotDistance& distance) {
  visit(distance.distance, distanceField("distance", kDistanceMeaning, {0.0, Distance::kFarthest}));
  rangeFields(visit, distance);
}
REGISTER_DEVICE_OF_SUITE(HandbotDistance, kSensor, "12 infrared distance sensors around the body.")

}  // namespace swarmanoid
