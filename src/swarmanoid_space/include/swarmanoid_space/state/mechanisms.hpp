/// What actuators command the mechanisms of a robot to do. Engines read nothing else of a robot's commands; what
/// mechanisms do stands in the wheel turns, the joints, the structural tree and the attachments of the space.
///
/// Phase  commands are written in `actuate`, and when the actuator is added to its robot: from then on the mechanism is
///        commanded.
#pragma once

#include <Eigen/Core>

namespace swarmanoid {

/// What part of what each wheel turns passes under it as ground, above 0: less than 1 where it slips.
struct WheelGrip {
  double left = 1.0;
  double right = 1.0;
};

/// Angular velocities with which the ground is to pass under the wheels [rad/s]. Motors turn them by 1 / `grip` as
/// fast.
struct WheelsCommand {
  bool is_driven = false;  ///< false: the robot has no actuator for them, and nothing drives or brakes it
  double left = 0.0;
  double right = 0.0;
  WheelGrip grip = {};  ///< of this tick; engines do not ask for it
};

/// What the wheels have really turned since the entity came into the space [rad], positive drives ahead: the engine
/// that moves the robot adds to it in `move`. Where a robot is blocked, or slips, its wheels turn all the same: an
/// actuator whose wheels slip, and which commands the engine what the ground is to pass under them, adds what they have
/// turned besides in `afterMove`. Moving it from outside turns no wheel.
struct WheelTurns {
  double left = 0.0;
  double right = 0.0;
};

/// In the frame that has the robot's heading and stands upright.
struct FlightCommand {
  bool is_driven = false;
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();  ///< [m/s]
  double yaw_rate = 0.0;                             ///< [rad/s]
};

struct JointCommand {
  enum class Mode {
    kNone,    ///< the robot has no actuator for it
    kAngle,   ///< turns to the angle `value` [rad], and holds it
    kSpeed,   ///< turns at the speed `value` [rad/s]
    kPassive  ///< the motor is off: forces turn it
  };

  Mode mode = Mode::kNone;
  double value = 0.0;
};

struct HolderCommand {
  bool is_commanded = false;   ///< false: the robot has no actuator for it
  bool holds = false;          ///< takes hold of what it reaches, or keeps it; false: lets go
  double winding_speed = 0.0;  ///< of a rope: positive shortens it [m/s]
};

}  // namespace swarmanoid
