/// Actuator: the two wheels of any robot with a differential drive.
#pragma once

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Angular velocities of the wheels [rad/s]; positive drives the robot forward (its x axis). The resulting speed
/// depends on the radius of the wheels; use DifferentialDrive to command a speed in m/s.
struct Wheels {
  static constexpr const char* kType = "wheels";

  double left = 0.0;   ///< [rad/s]
  double right = 0.0;  ///< [rad/s]

  void setAngularVelocity(double left_rad_per_s, double right_rad_per_s) {
    left = left_rad_per_s;
    right = right_rad_per_s;
  }
};

template <class Visitor>
void fields(Visitor& visit, Wheels& wheels) {
  visit(wheels.left,
        {"left", "rad/s", "angular velocity of the left wheel, positive drives ahead; cut to the motor's maximum"});
  visit(wheels.right,
        {"right", "rad/s", "angular velocity of the right wheel, positive drives ahead; cut to the motor's maximum"});
}
REGISTER_DEVICE_OF_SUITE(Wheels, kActuator, "Two wheels on one axle, left and right.")

}  // namespace swarmanoid
