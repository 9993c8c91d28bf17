/// Actuator and sensor: the magnet on top of an eyebot, by which it hangs under a ferromagnetic ceiling with its rotors
/// at rest (thesis 1).
#pragma once

namespace swarmanoid {

/// On: it holds what it touches, if that is ferromagnetic. Off: it lets go, and the eyebot flies on from there.
struct EyebotMagnet {
  static constexpr const char* kType = "eyebot_magnet";

  bool on = false;

  bool isFinite() const { return true; }
};

/// As of the end of the last tick.
struct EyebotMagnetState {
  static constexpr const char* kType = "eyebot_magnet_state";

  bool attached = false;
};

}  // namespace swarmanoid
