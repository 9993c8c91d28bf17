/// Actuator: the two treels of a footbot. A treel is a track combined with a wheel.
#pragma once

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Angular velocities of the wheels [rad/s]; positive drives the robot forward (its x axis).
struct FootbotWheels {
  static constexpr const char* kType = "footbot_wheels";
  static constexpr const char* kRobot = "footbot";

  static constexpr double kRadius = 0.029;           ///< of the wheels [m]
  static constexpr double kSeparation = 0.140;       ///< between them [m]
  static constexpr double kFastest = 0.3 / kRadius;  ///< of a wheel, either way [rad/s]

  double left = 0.0;   ///< [rad/s]
  double right = 0.0;  ///< [rad/s]

  void setAngularVelocity(double left_rad_per_s, double right_rad_per_s) {
    left = left_rad_per_s;
    right = right_rad_per_s;
  }
  /// Sets both wheels from speed and turn rate.
  /// @param speed ahead [m/s]; @param turn_rate [rad/s], counter-clockwise
  void drive(double speed, double turn_rate) {
    const double difference = 0.5 * turn_rate * kSeparation;
    setAngularVelocity((speed - difference) / kRadius, (speed + difference) / kRadius);
  }
  double speed() const { return 0.5 * (left + right) * kRadius; }
  double turnRate() const { return (right - left) * kRadius / kSeparation; }
};

template <class Visitor>
void fields(Visitor& visit, FootbotWheels& wheels) {
  visit(wheels.left,
        {"left", "rad/s", "angular velocity of the left wheel, positive drives ahead; cut to the motor's maximum"});
  visit(wheels.right,
        {"right", "rad/s", "angular velocity of the right wheel, positive drives ahead; cut to the motor's maximum"});
}
REGISTER_DEVICE_OF_SUITE(FootbotWheels, kActuator, "Two treels: tracks and wheels on one axle, left and right.")

}  // namespace swarmanoid
