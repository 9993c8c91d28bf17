/// Sensor: the infrared distance sensors of an eyebot: a ring of 16, one that looks up and one that looks down.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_interface/devices/ring.hpp"

namespace swarmanoid {

/// Readings by the law of Distance::reading [m]. Sensor 0 of the ring looks straight ahead (the robot's x axis), the
/// others follow counter-clockwise every 22.5 degrees.
struct EyebotDistance {
  static constexpr const char* kType = "eyebot_distance";
  static constexpr const char* kRobot = "eyebot";
  static constexpr std::size_t kAround = 16;
  static constexpr std::size_t kCount = kAround + 2;  ///< the ring, then the upward and the downward sensor
  static constexpr double kRingRadius = 0.25;         ///< of the ring, around the robot's axis [m]
  static constexpr double kUpHeight = 0.36;           ///< of the upward sensor, in the robot's frame [m]
  static constexpr double kDownHeight = 0.15;         ///< of the downward sensor, in the robot's frame [m]
  /// Measuring range of a Sharp GP2Y0A02YK0F (data sheet E4-A00101EN: 20 to 150 cm) [m].
  static constexpr Range kUsualRange{0.2, 1.5};

  std::array<float, kAround> around = unmeasuredDistances<kAround>();
  float up = std::numeric_limits<float>::quiet_NaN();
  float down = std::numeric_limits<float>::quiet_NaN();
  float range_min = static_cast<float>(kUsualRange.minimum);  ///< nearer objects are too close [m]
  float range_max = static_cast<float>(kUsualRange.maximum);  ///< farther objects are out of range [m]

  /// Direction of sensor `i` of the ring in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi].
  static constexpr double angle(std::size_t i) { return ringAngle(i, kAround); }
  /// The reading of any sensor: the ring, then the upward, then the downward sensor.
  float& value(std::size_t i) { return i < kAround ? around[i] : i == kAround ? up : down; }
  float value(std::size_t i) const { return i < kAround ? around[i] : i == kAround ? up : down; }
};

template <class Visitor>
void fields(Visitor& visit, EyebotDistance& distance) {
  constexpr Range kAny{0.0, Distance::kFarthest};
  visit(distance.around, distanceField("around", kDistanceMeaning, kAny));
  visit(distance.up, distanceField("up", "as `around`, upwards", kAny));
  visit(distance.down, distanceField("down", "as `around`, downwards", kAny));
  rangeFields(visit, distance);
}
REGISTER_DEVICE_OF_SUITE(EyebotDistance, kSensor,
                         "16 infrared distance sensors around the body, one upwards, one downwards.")

}  // namespace swarmanoid
