/// Actuator: the two treels of a footbot.
#pragma once

#include <cmath>

namespace swarmanoid {

/// Angular velocities of the wheels [rad/s]; positive drives the robot forward (its x axis).
struct FootbotWheels {
  static constexpr const char* kType = "footbot_wheels";

  static constexpr double kRadius = 0.029;      ///< of the wheels [m]
  static constexpr double kSeparation = 0.140;  ///< between them [m]

  double left = 0.0;   ///< [rad/s]
  double right = 0.0;  ///< [rad/s]

  void setAngularVelocity(double left_rad_per_s, double right_rad_per_s) {
    left = left_rad_per_s;
    right = right_rad_per_s;
  }
  /// The same by speed and turn rate.
  /// @param speed ahead [m/s]; @param turn_rate [rad/s], counter-clockwise
  void drive(double speed, double turn_rate) {
    const double difference = 0.5 * turn_rate * kSeparation;
    setAngularVelocity((speed - difference) / kRadius, (speed + difference) / kRadius);
  }
  double speed() const { return 0.5 * (left + right) * kRadius; }
  double turnRate() const { return (right - left) * kRadius / kSeparation; }
  bool isFinite() const { return std::isfinite(left) && std::isfinite(right); }
};

}  // namespace swarmanoid
