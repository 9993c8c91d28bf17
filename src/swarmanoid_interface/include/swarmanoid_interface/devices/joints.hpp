/// Actuator and sensor: the joints of any robot, as many as it has. Wheels are not among them.
///
/// Joints are in the order of the robot's model: parents come before children, and joints of one link are in the order
/// of their names. Angles are right-handed about the joints' axes, with the zero of the URDF.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// The commands of the joints' motors. Their initial values hold the angle 0, as does a robot without this device.
/// Commands beyond the number of joints of the robot are ignored.
struct Joints {
  static constexpr const char* kType = "joints";
  static constexpr std::size_t kMost = 16;

  enum class Mode : std::uint8_t {
    kAngle,   ///< turns to an angle, and holds it; a joint without stops takes the shorter way
    kSpeed,   ///< turns at a speed
    kPassive  ///< the motor is off: forces turn the joint
  };

  struct Joint {
    Mode mode = Mode::kAngle;
    double angle = 0.0;  ///< target in mode kAngle [rad]
    double speed = 0.0;  ///< target in mode kSpeed [rad/s]

    void holdAngle(double rad) { *this = {Mode::kAngle, rad, 0.0}; }
    void turnAt(double rad_per_s) { *this = {Mode::kSpeed, 0.0, rad_per_s}; }
    void letTurn() { *this = {Mode::kPassive, 0.0, 0.0}; }
  };

  std::array<Joint, kMost> joints{};
};

template <class Visitor>
void fields(Visitor& visit, Joints::Joint& joint) {
  visit(joint.mode, {"mode", "", "0: turns to an angle and holds it; 1: turns at a speed; 2: the motor is off"});
  visit(joint.angle, {"angle", "rad", "to turn to in mode 0; cut to the joint's stops"});
  visit(joint.speed, {"speed", "rad/s", "to turn at in mode 1; cut to the motor's maximum"});
}
template <class Visitor>
void fields(Visitor& visit, Joints& joints) {
  visit(joints.joints, {"joints"});
}
/// The joints hold their present angles; passive ones stay passive.
inline bool stopSafely(Joints& joints, const SafeStopMoment& /*moment*/) {
  for (Joints::Joint& joint : joints.joints) {
    if (joint.mode != Joints::Mode::kPassive) {
      joint.turnAt(0.0);
    }
  }
  return true;
}
REGISTER_DEVICE_OF_SUITE(Joints, kActuator, "Joints that turn links of the robot, as many as it has.")

/// The readings of the joints' encoders and motors, as of the end of the last tick. The span is valid until the next
/// tick.
struct JointStates {
  static constexpr const char* kType = "joint_states";
  static constexpr std::size_t kMost = Joints::kMost;

  struct Joint {
    double angle = 0.0;   ///< [rad]; in (-pi, pi] for a joint without stops
    double speed = 0.0;   ///< [rad/s]
    double effort = 0.0;  ///< of the motor and the stops, along positive angles; 0 in engines without forces [N m]
  };

  Span<const Joint> joints;
};

template <class Visitor>
void fields(Visitor& visit, JointStates::Joint& joint) {
  visit(joint.angle, {"angle", "rad", "of the link relative to its parent link"});
  visit(joint.speed, {"speed", "rad/s", "how fast it turns"});
  visit(joint.effort, {"effort", "N m", "of motor and stops, along positive angles; 0 in engines without forces"});
}
template <class Visitor>
void fields(Visitor& visit, JointStates& states) {
  visit(states.joints, {"joints"});
}
REGISTER_DEVICE_OF_SUITE(JointStates, kSensor, "Encoders and torque sensors of the joints, as many as the robot has.")

}  // namespace swarmanoid
