/// Actuator and sensor: the rope of a handbot, which it shoots straight up along its own z axis. A magnet at the end
/// holds on ferromagnetic ceilings; the rope is wound in to climb and out to come down (thesis 1).
#pragma once

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Shot: the rope flies up, and attaches if it reaches a ferromagnetic surface within its length. If it reaches none,
/// is torn off, or its anchor is removed, it returns to the launcher, and is shot again only after `shot` was false.
/// Not shot: the magnet releases its hold and the rope is back in its launcher.
struct HandbotRope {
  static constexpr const char* kType = "handbot_rope";
  static constexpr const char* kRobot = "handbot";

  static constexpr double kMount = 0.29;        ///< height of the launcher in the robot's frame [m]
  static constexpr double kUsualFastest = 0.2;  ///< of winding, in and out [m/s]

  bool shot = false;
  double winding_speed = 0.0;  ///< [m/s]; positive shortens the rope, if the motor is strong enough
};

template <class Visitor>
void fields(Visitor& visit, HandbotRope& rope) {
  visit(rope.shot, {"shot", "", "true: it flies up, and holds ferromagnetic objects; false: it lets go and is back"});
  visit(rope.winding_speed, {"winding_speed", "m/s", "positive shortens the rope; cut to max_speed either way"});
}
/// `shot` stays as it is, so that a robot that hangs by the rope does not fall.
inline bool stopSafely(HandbotRope& rope, const SafeStopMoment& /*moment*/) {
  rope.winding_speed = 0.0;
  return true;
}
REGISTER_DEVICE_OF_SUITE(HandbotRope, kActuator,
                         "The rope with a magnet at its end, shot straight up along the robot's z axis.")

/// The state at the end of the last tick.
struct HandbotRopeState {
  static constexpr const char* kType = "handbot_rope_state";
  static constexpr const char* kRobot = "handbot";

  bool attached = false;
  double length = 0.0;   ///< from the launcher to the magnet, when taut; 0 when not attached [m]
  double tension = 0.0;  ///< without the noise of single engine steps; a slack rope has none [N]
};

template <class Visitor>
void fields(Visitor& visit, HandbotRopeState& rope) {
  visit(rope.attached, {"attached", "", "whether the magnet holds something"});
  visit(rope.length, {"length", "m", "of the rope that is out; 0 when it is not attached", {0.0, kInfinity}});
  visit(rope.tension, {"tension", "N", "smoothed; 0 for a slack rope", {0.0, kInfinity}});
}
REGISTER_DEVICE_OF_SUITE(HandbotRopeState, kSensor, "The rope's encoder and tension sensor.")

}  // namespace swarmanoid
