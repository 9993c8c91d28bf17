/// Commands of actuators to the mechanisms of a robot. Engines read no other commands of a robot; the actual motion of
/// mechanisms is in the wheel turns, the joints, the structural tree and the attachments of the space.
///
/// Phase  commands are written in `actuate`, and when the actuator is added to its robot, from which time the mechanism
///        is commanded.
#pragma once

#include <Eigen/Core>

namespace swarmanoid {

/// Ratio of ground distance to rolled distance of each wheel, above 0: less than 1 if it slips.
struct WheelGrip {
  double left = 1.0;
  double right = 1.0;
};

/// Ground distance per time under the wheels, as angular velocities [rad/s]. Motors turn the wheels faster, by
/// 1 / `grip`.
struct WheelsCommand {
  bool is_driven = false;  ///< false: the robot has no actuator for them; nothing drives or brakes it
  double left = 0.0;
  double right = 0.0;
  WheelGrip grip = {};  ///< of this tick; engines do not read it
};

/// Actual wheel angles since the entity was added to the space [rad], positive ahead. The engine that moves the robot
/// adds to them in `move`. The wheels of a robot that is blocked or slips turn all the same: since the command of a
/// slipping wheel is its ground distance, the actuator adds the rest in `afterMove`. Moves from outside turn no wheel.
struct WheelTurns {
  double left = 0.0;
  double right = 0.0;
};

/// In an upright frame with the robot's heading.
struct FlightCommand {
  bool is_driven = false;
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();  ///< [m/s]
  double yaw_rate = 0.0;                             ///< [rad/s]
};

struct JointCommand {
  enum class Mode {
    kNone,    ///< the robot has no actuator for it
    kAngle,   ///< turns to the angle `value` [rad] and holds it
    kSpeed,   ///< turns at the speed `value` [rad/s]
    kPassive  ///< the motor is off: external forces turn it
  };

  Mode mode = Mode::kNone;
  double value = 0.0;
};

struct HolderCommand {
  bool is_commanded = false;   ///< false: the robot has no actuator for it
  bool holds = false;          ///< grips or attaches to an entity in reach, and keeps it; false: releases it
  double winding_speed = 0.0;  ///< of a rope: positive shortens it [m/s]
};

}  // namespace swarmanoid
