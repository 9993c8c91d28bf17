/// Actuator: the two wheels of any robot with a differential drive, commanded by speed and turn rate. The simulator
/// converts them to wheel speeds by the robot's description; on a robot, its driver does.
#pragma once

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

struct DifferentialDrive {
  static constexpr const char* kType = "differential_drive";

  double speed = 0.0;      ///< ahead, along the robot's x axis [m/s]
  double turn_rate = 0.0;  ///< counter-clockwise [rad/s]

  void drive(double speed_ahead, double turn_rate_ccw) {
    speed = speed_ahead;
    turn_rate = turn_rate_ccw;
  }
};

template <class Visitor>
void fields(Visitor& visit, DifferentialDrive& drive) {
  visit(drive.speed, {"speed", "m/s", "along the robot's x axis; cut to the limits of the wheels"});
  visit(drive.turn_rate, {"turn_rate", "rad/s", "counter-clockwise; cut to the limits of the wheels"});
}
REGISTER_DEVICE_OF_SUITE(DifferentialDrive, kActuator, "Two wheels on one axle, by speed and turn rate.")

}  // namespace swarmanoid
