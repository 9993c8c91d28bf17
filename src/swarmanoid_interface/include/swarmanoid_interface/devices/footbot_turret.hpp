/// Actuator and sensor: the turret of a footbot, the ring that carries the gripper and turns against the chassis.
///
/// Frames: the robot's; angles are counter-clockwise seen from above, 0 is straight ahead. Only the gripper turns with
/// the turret: infrared sensors, LEDs, camera and the strip by which the robot is gripped stay with the chassis.
#pragma once

#include <cmath>
#include <cstdint>

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// The command of the turret's motor. Its initial value holds the angle 0, as does a robot without this device.
struct FootbotTurret {
  static constexpr const char* kType = "footbot_turret";
  static constexpr const char* kRobot = "footbot";

  static constexpr double kFastest = 3.0;  ///< relative to the chassis, either way [rad/s]

  enum class Mode : std::uint8_t {
    kAngle,   ///< turns to an angle, the shorter way, and holds it
    kSpeed,   ///< turns continuously at a speed
    kPassive  ///< the motor is off: forces on the held object turn the turret
  };

  Mode mode = Mode::kAngle;
  double angle = 0.0;  ///< target in mode kAngle [rad]
  double speed = 0.0;  ///< target in mode kSpeed [rad/s]

  void holdAngle(double rad) { *this = {Mode::kAngle, rad, 0.0}; }
  void turnAt(double rad_per_s) { *this = {Mode::kSpeed, 0.0, rad_per_s}; }
  void letTurn() { *this = {Mode::kPassive, 0.0, 0.0}; }
};

template <class Visitor>
void fields(Visitor& visit, FootbotTurret& turret) {
  visit(turret.mode, {"mode", "", "0: turns to an angle and holds it; 1: turns at a speed; 2: the motor is off"});
  visit(turret.angle, {"angle", "rad", "to turn to in mode 0, in the robot's frame; modulo a turn"});
  visit(turret.speed, {"speed", "rad/s", "to turn at in mode 1; cut to the motor's maximum"});
}
/// The turret holds its present angle; a passive turret stays passive.
inline bool stopSafely(FootbotTurret& turret, const SafeStopMoment& /*moment*/) {
  if (turret.mode != FootbotTurret::Mode::kPassive) {
    turret.turnAt(0.0);
  }
  return true;
}
REGISTER_DEVICE_OF_SUITE(FootbotTurret, kActuator, "The ring that carries the gripper and turns against the chassis.")

/// The readings of the turret's encoder and motor, as of the end of the last tick.
struct FootbotTurretState {
  static constexpr const char* kType = "footbot_turret_state";
  static constexpr const char* kRobot = "footbot";

  double angle = 0.0;   ///< in (-pi, pi] [rad]
  double speed = 0.0;   ///< [rad/s]
  double torque = 0.0;  ///< of the motor on the turret; 0 in engines without forces [N m]
};

template <class Visitor>
void fields(Visitor& visit, FootbotTurretState& turret) {
  visit(turret.angle, {"angle", "rad", "of the gripper in the robot's frame", {-M_PI, M_PI}, true});
  visit(turret.speed, {"speed", "rad/s", "how fast it turns against the chassis"});
  visit(turret.torque, {"torque", "N m", "of the motor on the turret; 0 without load, and in engines without forces"});
}
REGISTER_DEVICE_OF_SUITE(FootbotTurretState, kSensor, "The turret's encoder, and the torque of its motor.")

}  // namespace swarmanoid
