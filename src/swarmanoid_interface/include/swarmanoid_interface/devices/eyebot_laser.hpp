/// Actuator: the laser pointer under an eyebot. Its red spot on the ground is how the eyebot talks to footbots
/// (thesis 4.3).
#pragma once

#include <cmath>

namespace swarmanoid {

/// With tilt 0 the beam goes straight down; it is tilted towards the direction `pan`.
struct EyebotLaser {
  static constexpr const char* kType = "eyebot_laser";

  bool on = false;
  double pan = 0.0;   ///< in the robot's frame [rad], counter-clockwise from ahead
  double tilt = 0.0;  ///< from straight down [rad], limited to 0.8 either way

  bool isFinite() const { return std::isfinite(pan) && std::isfinite(tilt); }
};

}  // namespace swarmanoid
