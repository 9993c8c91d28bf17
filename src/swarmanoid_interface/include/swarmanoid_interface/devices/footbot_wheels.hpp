/// Actuator: the two treels of a footbot.
#pragma once

#include <cmath>

namespace swarmanoid {

/// Angular velocities of the wheels [rad/s]; positive drives the robot forward (its x axis).
struct FootbotWheels {
  static constexpr const char* kType = "footbot_wheels";

  double left = 0.0;   ///< [rad/s]
  double right = 0.0;  ///< [rad/s]

  void setAngularVelocity(double left_rad_per_s, double right_rad_per_s) {
    left = left_rad_per_s;
    right = right_rad_per_s;
  }
  bool isFinite() const { return std::isfinite(left) && std::isfinite(right); }
};

}  // namespace swarmanoid
