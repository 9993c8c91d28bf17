/// Actuator and sensor: the rigid gripper at the front of a footbot.
#pragma once

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// The command of the gripper. A closed gripper holds the object within its reach; an open gripper releases it.
struct FootbotGripper {
  static constexpr const char* kType = "footbot_gripper";
  static constexpr const char* kRobot = "footbot";

  static constexpr double kReach = 0.11;  ///< of its tip from the robot's axis [m]

  bool closed = false;

  void close() { closed = true; }
  void open() { closed = false; }
};

template <class Visitor>
void fields(Visitor& visit, FootbotGripper& gripper) {
  visit(gripper.closed, {"closed", "", "closed: grips an object within reach; open: releases it"});
}
/// The command stays, so that a held object is not dropped.
inline bool stopSafely(FootbotGripper& /*gripper*/, const SafeStopMoment& /*moment*/) { return true; }
REGISTER_DEVICE_OF_SUITE(FootbotGripper, kActuator, "The rigid gripper at the front, which turns with the turret.")

/// The reading of the gripper's contact switch.
struct FootbotGripperState {
  static constexpr const char* kType = "footbot_gripper_state";
  static constexpr const char* kRobot = "footbot";

  bool gripping = false;  ///< an object is held, as of the end of the last tick
};

template <class Visitor>
void fields(Visitor& visit, FootbotGripperState& gripper) {
  visit(gripper.gripping, {"gripping", "", "whether the gripper holds something"});
}
REGISTER_DEVICE_OF_SUITE(FootbotGripperState, kSensor, "The gripper's contact switch.")

}  // namespace swarmanoid
