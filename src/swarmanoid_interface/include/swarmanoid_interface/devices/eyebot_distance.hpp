/// Sensor: the infrared distance sensors of an eyebot, 16 around it, one that looks up and one that looks down.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_interface/devices/ring.hpp"

namespace swarmanoid {

/// Readings by the law of Distance::reading [m]. Sensor 0 of those around looks straight ahead (the robot's x axis),
/// the others follow counter-clockwise every 22.5 degrees.
struct EyebotDistance {
  static constexpr const char* kType = "eyebot_distance";
  static constexpr const char* kRobot = "eyebot";
  static constexpr std::size_t kAround = 16;
  static constexpr std::size_t kCount = kAround + 2;  ///< with the one that looks up, and then the one that looks down
  static constexpr double kRingRadius = 0.25;         ///< of the sensors around the robot's axis [m]
  static constexpr double kUpHeight = 0.36;           ///< of the one that looks up, in the robot's frame [m]
  static constexpr double kDownHeight = 0.15;         ///< of the one that looks down, likewise [m]
  /// As a Sharp GP2Y0A02YK0F measures (data sheet E4-A00101EN: 20 to 150 cm) [m].
  static constexpr Range kUsualRange{0.2, 1.5};

  std::array<float, kAround> around = unmeasuredDistances<kAround>();
  float up = std::numeric_limits<float>::quiet_NaN();
  float down = std::numeric_limits<float>::quiet_NaN();
  float range_min = static_cast<float>(kUsualRange.minimum);  ///< what is nearer is too close [m]
  float range_max = static_cast<float>(kUsualRange.maximum);  ///< what is farther is out of range [m]

  /// Direction of sensor `i` of those around in the robot's frame [rad], counter-clockwise from ahead, in (-pi, pi].
  static constexpr double angle(std::size_t i) { return ringAngle(i, kAround); }
  /// The reading of any sensor: those around, then the one that looks up, then the one that looks down.
  float& value(std::size_t i) { return i < kAround ? around[i] : i == kAround ? up : down; }
  float value(std::size_t i) const { return i < kAround ? around[i] : i == kAround ? up : down; }
};

template <class Visitor>
void fields(Visitor& visit, EyebotDistance& distance) {
  constexpr Range kAny{0.0, Distance::kFarthest};
  visit(distance.around, distanceField("around", kDistanceMeaning, kAny));
  visit(distance.up, distanceField("up", "likewise", kAny));
  visit(distance.down, distanceField("down", "likewise", kAny));
  rangeFields(visit, distance);
}
REGISTER_DEVICE_OF_SUITE(EyebotDistance, kSensor,
                         "16 infrared distance sensors around the body, one upwards, one downwards.")

}  // namespace swarmanoid
