/// Actuator and sensor: the two arms of a handbot (thesis 1, figure 1.2). Each has a shoulder that raises it, an elbow
/// that swings its forearm sideways and a wrist that turns its hand. With all angles 0 an arm is stretched ahead.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace swarmanoid {

/// Where an arm's joints are to be [rad], right-handed about the axes that the URDF gives: y, z, x of the robot while
/// the arm is stretched ahead.
struct ArmAngles {
  double shoulder = 0.0;  ///< -1.57 (straight up) to 0.7
  double elbow = 0.0;     ///< -1.2 (to the right) to 1.2 (to the left)
  double wrist = 0.0;     ///< -3.14 to 3.14

  bool isFinite() const { return std::isfinite(shoulder) && std::isfinite(elbow) && std::isfinite(wrist); }
};

/// The joints go there as fast as their motors can, and hold the commanded angles with no more than the motors' torque.
struct HandbotArms {
  static constexpr const char* kType = "handbot_arms";

  ArmAngles left;
  ArmAngles right;

  bool isFinite() const { return left.isFinite() && right.isFinite(); }
};

/// Where the joints are, as of the end of the last tick, and what their motors give.
struct HandbotArmsState {
  static constexpr const char* kType = "handbot_arms_state";
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

}  // namespace swarmanoid
