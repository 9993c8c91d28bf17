/// Actuator: the mounting of the eyebot's EyebotPanTiltCamera, which turns it.
#pragma once

#include <algorithm>

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Target direction of the camera, which is first panned about the robot's z axis, then tilted out of the robot's
/// horizontal plane: with both at 0 it looks ahead. Each axis turns to its target at its maximum speed, without
/// wrapping around.
struct EyebotPanTilt {
  static constexpr const char* kType = "eyebot_pan_tilt";
  static constexpr const char* kRobot = "eyebot";

  static constexpr double kMaxPan = 2.6;     ///< either way [rad]: cables prevent it from looking straight back
  static constexpr double kLowest = -1.57;   ///< tilt at which it looks straight down [rad]
  static constexpr double kHighest = 0.5;    ///< tilt under the rotors [rad]
  static constexpr double kPanSpeed = 2.0;   ///< maximum [rad/s]
  static constexpr double kTiltSpeed = 1.5;  ///< maximum [rad/s]

  double pan = 0.0;   ///< [rad], counter-clockwise from ahead
  double tilt = 0.0;  ///< [rad], positive upwards

  /// Returns the angle after turning from `from` towards `to` for `dt`. @param fastest [rad/s] @param dt [s] @return
  /// [rad]
  static double turned(double from, double to, double fastest, double dt) {
    return from + std::clamp(to - from, -fastest * dt, fastest * dt);
  }
};

template <class Visitor>
void fields(Visitor& visit, EyebotPanTilt& mounting) {
  visit(mounting.pan,
        {"pan", "rad", "counter-clockwise from ahead", {-EyebotPanTilt::kMaxPan, EyebotPanTilt::kMaxPan}});
  visit(mounting.tilt,
        {"tilt", "rad", "upwards out of the robot's plane", {EyebotPanTilt::kLowest, EyebotPanTilt::kHighest}});
}
/// The command stays, so the camera keeps its last target direction.
inline bool stopSafely(EyebotPanTilt& /*mounting*/, const SafeStopMoment& /*moment*/) { return true; }
REGISTER_DEVICE_OF_SUITE(EyebotPanTilt, kActuator, "Pans and tilts the camera of eyebot_pan_tilt_camera.")

}  // namespace swarmanoid
