/// Actuator and sensor: the magnet on top of an eyebot, by which it hangs under a ferromagnetic ceiling with its rotors
/// at rest (thesis 1).
#pragma once

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// On: the magnet holds the surface it touches, if that is ferromagnetic. Off: it releases the surface, and the eyebot
/// flies on from there.
struct EyebotMagnet {
  static constexpr const char* kType = "eyebot_magnet";
  static constexpr const char* kRobot = "eyebot";

  static constexpr double kMount = 0.54;  ///< height of the magnet in the robot's frame [m]

  bool on = false;
};

template <class Visitor>
void fields(Visitor& visit, EyebotMagnet& magnet) {
  visit(magnet.on, {"on", "", "on: holds a ferromagnetic object that it touches; off: releases it"});
}
/// The command stays, so that a hanging eyebot does not fall.
inline bool stopSafely(EyebotMagnet& /*magnet*/, const SafeStopMoment& /*moment*/) { return true; }
REGISTER_DEVICE_OF_SUITE(EyebotMagnet, kActuator, "The magnet on top, by which the robot hangs under a ceiling.")

/// The state at the end of the last tick.
struct EyebotMagnetState {
  static constexpr const char* kType = "eyebot_magnet_state";
  static constexpr const char* kRobot = "eyebot";

  bool attached = false;
};

template <class Visitor>
void fields(Visitor& visit, EyebotMagnetState& magnet) {
  visit(magnet.attached, {"attached", "", "whether the magnet holds something"});
}
REGISTER_DEVICE_OF_SUITE(EyebotMagnetState, kSensor, "The magnet's contact switch.")

}  // namespace swarmanoid
