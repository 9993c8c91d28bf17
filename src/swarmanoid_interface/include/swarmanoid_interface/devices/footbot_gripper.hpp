/// Actuator and sensor: the rigid gripper at the front of a footbot.
#pragma once

namespace swarmanoid {

/// The command of the gripper. A closed gripper holds what it reaches; an open one lets go.
struct FootbotGripper {
  static constexpr const char* kType = "footbot_gripper";

  bool closed = false;

  void close() { closed = true; }
  void open() { closed = false; }
  bool isFinite() const { return true; }
};

/// What the gripper's contact switch says.
struct FootbotGripperState {
  static constexpr const char* kType = "footbot_gripper_state";

  bool gripping = false;  ///< something is held, as of the end of the last tick
};

}  // namespace swarmanoid
