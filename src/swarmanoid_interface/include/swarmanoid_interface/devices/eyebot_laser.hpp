/// Actuator: the laser pointer under an eyebot. With its red spot on the ground the eyebot signals to footbots (thesis
/// 4.3).
#pragma once

#include <array>

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// With tilt 0 the beam goes straight down; it is tilted towards the direction `pan`.
struct EyebotLaser {
  static constexpr const char* kType = "eyebot_laser";
  static constexpr const char* kRobot = "eyebot";

  static constexpr double kMaxTilt = 0.8;                          ///< either way [rad]
  static constexpr std::array<double, 3> kMount{0.05, 0.0, 0.15};  ///< origin of the beam in the robot's frame [m]

  bool on = false;
  double pan = 0.0;   ///< in the robot's frame [rad], counter-clockwise from ahead
  double tilt = 0.0;  ///< from straight down [rad], limited to kMaxTilt either way
};

template <class Visitor>
void fields(Visitor& visit, EyebotLaser& laser) {
  visit(laser.on, {"on", "", "whether it shines"});
  visit(laser.pan, {"pan", "rad", "direction in the robot's frame towards which the beam is tilted"});
  visit(laser.tilt, {"tilt", "rad", "from straight down", {-EyebotLaser::kMaxTilt, EyebotLaser::kMaxTilt}});
}
inline bool stopSafely(EyebotLaser& laser, const SafeStopMoment& /*moment*/) {
  laser.on = false;
  return true;
}
REGISTER_DEVICE_OF_SUITE(EyebotLaser, kActuator, "A laser pointer that makes a red spot on the surface below.")

}  // namespace swarmanoid
