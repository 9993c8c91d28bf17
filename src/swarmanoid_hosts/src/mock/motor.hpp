/// The motors of mock joints without stops.
#pragma once

#include "mock_state.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::mock {

/// Turns a joint to an angle, the shorter way, or at a speed; a passive joint does not turn.
/// @param motor has `mode`, one of kAngle, kSpeed and kPassive, and `angle` and `speed` @param fastest [rad/s]
template <class Motor>
void turnByMotor(const Motor& motor, double fastest, double dt, Joint& joint) {
  using Mode = decltype(motor.mode);
  double way = 0.0;
  if (motor.mode == Mode::kAngle) {
    way = wrapAngle(motor.angle - joint.angle);
  } else if (motor.mode == Mode::kSpeed) {
    way = motor.speed * dt;
  }
  joint.turn(way, fastest, dt);
  joint.angle = wrapAngle(joint.angle);
}

}  // namespace swarmanoid::mock
