/// Sensor: the infrared distance sensors of any robot, in any number and directions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// The reading of one sensor.
struct DistanceReading {
  /// [m]; by REP-117 infinity with nothing in range, -infinity with an object too close, NaN before the first tick
  float distance = std::numeric_limits<float>::quiet_NaN();
  float angle = 0.0F;  ///< direction of the sensor in the robot's frame [rad], counter-clockwise from ahead, (-pi, pi]
  float elevation = 0.0F;  ///< direction of the sensor upwards from level [rad], in [-pi/2, pi/2]
};

/// Readings in the order of the sensors: that of the links distance_0, distance_1, ... of the robot's description.
/// The span is valid until the next tick.
struct Distance {
  static constexpr const char* kType = "distances";
  static constexpr std::size_t kMostSensors = 64;
  /// Default measuring range, that of a Sharp GP2Y0A21YK0F (data sheet E4-A00201EN: 10 to 80 cm) [m].
  static constexpr Range kUsualRange{0.1, 0.8};
  static constexpr double kFarthest = 20.0;  ///< largest range that an experiment may set [m]

  Span<const DistanceReading> sensors;
  float range_min = static_cast<float>(kUsualRange.minimum);  ///< of all sensors: nearer objects are too close [m]
  float range_max = static_cast<float>(kUsualRange.maximum);  ///< of all sensors: farther objects are out of range [m]

  /// The response of all distance sensors of the suite (REP-117).
  /// @param distance to the nearest obstacle ahead, infinity if there is none [m] @param range measuring range [m]
  static float reading(double distance, Range range) {
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    return distance > range.maximum ? kInfinite : distance < range.minimum ? -kInfinite : static_cast<float>(distance);
  }

  /// The response of a sensor that measures by triangulation and does not detect objects that are too close. Its
  /// voltage is proportional to 1 / distance within its range. Below the minimum, where the light spot leaves the
  /// detector, the voltage falls, by assumption in proportion to the distance. So the sensor reads the larger distance
  /// that has the same voltage.
  static float foldedReading(double distance, Range range) {
    const bool is_too_close = distance < range.minimum;
    const double seen = is_too_close ? range.minimum * range.minimum / std::max(distance, kTouching) : distance;
    return reading(seen, range);
  }
  static constexpr double kTouching = 1e-6;  ///< smaller distances count as this [m]
};

/// Distances before the first tick: NaN (REP-117).
template <std::size_t count>
std::array<float, count> unmeasuredDistances() {
  std::array<float, count> distances{};
  distances.fill(std::numeric_limits<float>::quiet_NaN());
  return distances;
}

/// Describes the fields of a device that hold its measuring range.
template <class Visitor, class Device>
void rangeFields(Visitor& visit, Device& device) {
  visit(device.range_min,
        {"range_min", "m", "minimum range: nearer objects are too close", {0.0, Distance::kFarthest}});
  visit(device.range_max,
        {"range_max", "m", "maximum range: farther objects are out of range", {0.0, Distance::kFarthest}});
}

constexpr const char* kDistanceMeaning = "inf: out of range; -inf: too close; nan: not measured";

template <class Visitor>
void fields(Visitor& visit, DistanceReading& reading) {
  visit(reading.distance, distanceField("distance", kDistanceMeaning, {0.0, Distance::kFarthest}));
  visit(reading.angle, {"angle", "rad", "direction of the sensor in the robot's frame", {-M_PI, M_PI}, true});
  visit(reading.elevation,
        {"elevation", "rad", "elevation of that direction above the horizontal", {-M_PI / 2.0, M_PI / 2.0}});
}
template <class Visitor>
void fields(Visitor& visit, Distance& distance) {
  visit(distance.sensors, {"sensors"});
  rangeFields(visit, distance);
}
REGISTER_DEVICE_OF_SUITE(Distance, kSensor, "Infrared distance sensors, as many as the robot has, in any direction.")

}  // namespace swarmanoid
