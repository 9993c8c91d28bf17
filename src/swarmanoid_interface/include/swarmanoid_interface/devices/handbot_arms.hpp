/// Actuator and sensor: the two arms of a handbot (thesis 1, figure 1.2). Each has a shoulder that raises it, an elbow
/// that swings its forearm sideways and a wrist that turns its hand. With all angles 0 an arm is stretched ahead.
#pragma once

#include <array>
#include <cstddef>

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Target angles of an arm's joints [rad], right-handed about the axes in the URDF: y, z, x of the robot while the arm
/// is stretched ahead.
struct ArmAngles {
  double shoulder = 0.0;  ///< -1.57 (straight up) to 0.7
  double elbow = 0.0;     ///< -1.2 (to the right) to 1.2 (to the left)
  double wrist = 0.0;     ///< -3.14 to 3.14
};

template <class Visitor>
void fields(Visitor& visit, ArmAngles& arm) {
  visit(arm.shoulder, {"shoulder", "rad", "about y: -1.57 is straight up", {-1.57, 0.7}});
  visit(arm.elbow, {"elbow", "rad", "about z: positive swings the forearm to the left", {-1.2, 1.2}});
  visit(arm.wrist, {"wrist", "rad", "about x: turns the hand", {-3.14, 3.14}});
}

/// The joints move to the commanded angles as fast as their motors can, and hold them with at most the motors' torque.
struct HandbotArms {
  static constexpr const char* kType = "handbot_arms";
  static constexpr const char* kRobot = "handbot";

  static constexpr double kFastest = 2.0;  ///< of a joint, either way [rad/s]

  ArmAngles left;
  ArmAngles right;
};

template <class Visitor>
void fields(Visitor& visit, HandbotArms& arms) {
  visit(arms.left, {"left"});
  visit(arms.right, {"right"});
}
/// The command stays, so that a held object is not dropped.
inline bool stopSafely(HandbotArms& /*arms*/, const SafeStopMoment& /*moment*/) { return true; }
REGISTER_DEVICE_OF_SUITE(HandbotArms, kActuator, "Two arms, each with shoulder, elbow and wrist.")

/// The angles of the joints at the end of the last tick, and the torques of their motors.
struct HandbotArmsState {
  static constexpr const char* kType = "handbot_arms_state";
  static constexpr const char* kRobot = "handbot";
  static constexpr std::size_t kJoints = 6;
  /// Names of the joints in the URDF, in the order of `joints`.
  static constexpr std::array<const char*, kJoints> kNames{"left_shoulder",  "left_elbow",  "left_wrist",
                                                           "right_shoulder", "right_elbow", "right_wrist"};

  struct Joint {
    double angle = 0.0;   ///< [rad]
    double speed = 0.0;   ///< [rad/s]
    double effort = 0.0;  ///< of the motor and the stops, along positive angles [N m]
  };
  std::array<Joint, kJoints> joints{};
};

template <class Visitor>
void fields(Visitor& visit, HandbotArmsState::Joint& joint) {
  visit(joint.angle, {"angle", "rad", "left shoulder, elbow, wrist, then right"});
  visit(joint.speed, {"speed", "rad/s", "how fast it turns"});
  visit(joint.effort, {"effort", "N m", "of motor and stops, along positive angles"});
}
template <class Visitor>
void fields(Visitor& visit, HandbotArmsState& arms) {
  visit(arms.joints, {"joints"});
}
REGISTER_DEVICE_OF_SUITE(HandbotArmsState, kSensor, "Encoders and torque sensors of the arms' joints.")

}  // namespace swarmanoid
