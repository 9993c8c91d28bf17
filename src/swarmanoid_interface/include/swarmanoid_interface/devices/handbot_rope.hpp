/// Actuator and sensor: the rope of a handbot, which it shoots straight up along its own z axis. A magnet at the end
/// holds on ferromagnetic ceilings; the rope is wound in to climb and out to come down (thesis 1).
#pragma once

#include <cmath>

namespace swarmanoid {

/// Shot: the rope flies up, and holds if it meets something ferromagnetic within its length. If it meets nothing such,
/// is torn off, or loses what it holds, it comes back, and is shot again only after `shot` was false. Not shot: the
/// magnet lets go and the rope is back in its launcher.
struct HandbotRope {
  static constexpr const char* kType = "handbot_rope";

  bool shot = false;
  double winding_speed = 0.0;  ///< [m/s]; positive shortens the rope, as far as the motor is strong enough

  bool isFinite() const { return std::isfinite(winding_speed); }
};

/// As of the end of the last tick.
struct HandbotRopeState {
  static constexpr const char* kType = "handbot_rope_state";

  bool attached = false;
  double length = 0.0;   ///< from the launcher to the magnet, when taut; 0 when not attached [m]
  double tension = 0.0;  ///< without the noise of single engine steps; a slack rope has none [N]
};

}  // namespace swarmanoid
