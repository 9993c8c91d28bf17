/// Sensor: the distance from an eyebot to the nearest surface straight below it.
#pragma once

#include <limits>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/distance.hpp"

namespace swarmanoid {

/// Measured from the robot's origin, its lower face, along its own z axis downwards.
struct EyebotAltitude {
  static constexpr const char* kType = "eyebot_altitude";
  static constexpr const char* kRobot = "eyebot";

  static constexpr double kNearest = 0.02;    ///< nearer objects are too close [m]
  static constexpr double kUsualRange = 6.0;  ///< [m]
  static constexpr double kFarthest = 100.0;  ///< largest range that an experiment may set [m]

  /// [m]; by REP-117 infinity with nothing in range, -infinity with an object too close, as on the ground, NaN before
  /// the first tick
  float distance = std::numeric_limits<float>::quiet_NaN();
  float range_min = static_cast<float>(kNearest);     ///< nearer objects are too close [m]
  float range_max = static_cast<float>(kUsualRange);  ///< farther objects are out of range [m]
};

template <class Visitor>
void fields(Visitor& visit, EyebotAltitude& altitude) {
  constexpr Range kAny{0.0, EyebotAltitude::kFarthest};
  visit(altitude.distance, distanceField("distance", kDistanceMeaning, kAny));
  visit(altitude.range_min, {"range_min", "m", "minimum range: nearer objects are too close", kAny});
  visit(altitude.range_max, {"range_max", "m", "maximum range: farther objects are out of range", kAny});
}
REGISTER_DEVICE_OF_SUITE(EyebotAltitude, kSensor, "Distance to the ground straight below.")

}  // namespace swarmanoid
