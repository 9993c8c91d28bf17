/// Sensor: the encoders of the two wheels of any robot with a differential drive.
#pragma once

#include <cmath>

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Rotation of the wheels, slip included; positive drives the robot forward (its x axis). Carrying the robot away does
/// not turn the wheels.
struct WheelEncoders {
  static constexpr const char* kType = "wheel_encoders";

  struct Wheel {
    double turned = 0.0;  ///< since the robot's start [rad]
    double step = 0.0;    ///< in the last tick [rad]
    double speed = 0.0;   ///< the mean of the last tick [rad/s]
  };

  Wheel left;
  Wheel right;

  /// Quantises an angle as an encoder does: to whole steps, towards minus infinity. @param angle [rad]
  /// @param ticks_per_turn resolution; 0: unlimited @return [rad]
  static double counted(double angle, double ticks_per_turn) {
    if (ticks_per_turn == 0.0) {
      return angle;
    }
    const double step = 2.0 * M_PI / ticks_per_turn;
    return std::floor(angle / step) * step;
  }
};

template <class Visitor>
void fields(Visitor& visit, WheelEncoders::Wheel& wheel) {
  visit(wheel.turned, {"turned", "rad", "since the robot's start, positive drives ahead"});
  visit(wheel.step, {"step", "rad", "in the last tick"});
  visit(wheel.speed, {"speed", "rad/s", "mean of the last tick"});
}
template <class Visitor>
void fields(Visitor& visit, WheelEncoders& encoders) {
  visit(encoders.left, {"left"});
  visit(encoders.right, {"right"});
}
REGISTER_DEVICE_OF_SUITE(WheelEncoders, kSensor, "Encoders of the two wheels.")

}  // namespace swarmanoid
