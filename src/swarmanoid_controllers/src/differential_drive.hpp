/// Functions that drive a footbot towards a target and away from obstacles.
#pragma once

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid {

/// Turns on the spot while the target is to the side; otherwise drives a curve towards it.
/// @param bearing of the target [rad]; @param speed when it is straight ahead [m/s]
inline void steer(FootbotWheels& wheels, double bearing, double speed) {
  constexpr double kGain = 2.0;         // 1/s
  constexpr double kFastestTurn = 1.5;  // rad/s
  const double ahead = std::max(0.0, std::cos(bearing));
  wheels.drive(speed * ahead * ahead, std::clamp(kGain * bearing, -kFastestTurn, kFastestTurn));
}

/// The direction of obstacles, as the sum of the proximity readings taken as vectors.
struct ObstacleVector {
  double x = 0.0;  ///< ahead
  double y = 0.0;  ///< left

  /// @param half_field sensors farther to the side than this do not count [rad]
  explicit ObstacleVector(const FootbotProximity& proximity, double half_field = M_PI) {
    for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
      const double angle = FootbotProximity::angle(i);
      if (proximity.value[i] > 0.0F && std::abs(angle) <= half_field) {
        x += proximity.value[i] * std::cos(angle);
        y += proximity.value[i] * std::sin(angle);
      }
    }
  }
  double length() const { return std::hypot(x, y); }
  double bearing() const { return std::atan2(y, x); }
};

}  // namespace swarmanoid
