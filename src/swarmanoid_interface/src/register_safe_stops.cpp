// The safe stops of the suite's actuators.
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/devices/leds.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_interface/safe_stop.hpp"

namespace swarmanoid {

bool stopSafely(FootbotWheels& wheels, const SafeStopMoment&) {
  wheels = FootbotWheels{};
  return true;
}

bool stopSafely(FootbotTurret& turret, const SafeStopMoment&) {
  if (turret.mode != FootbotTurret::Mode::kPassive) {
    turret.turnAt(0.0);
  }
  return true;
}

bool stopSafely(EyebotVelocity& velocity, const SafeStopMoment& moment) {
  velocity = EyebotVelocity{};
  const Robot& robot = moment.robot;
  if (robot.hasSensor(EyebotMagnetState::kType) && robot.sensor<EyebotMagnetState>().attached) {
    return true;
  }
  const SafeStopSettings& settings = moment.settings;
  if (moment.since >= settings.hover && moment.since < settings.hover + settings.descend_time) {
    velocity.linear.z() = -settings.descend_speed;
  }
  return moment.since >= settings.hover + settings.descend_time;
}

bool stopSafely(EyebotLaser& laser, const SafeStopMoment&) {
  laser.on = false;
  return true;
}

bool stopSafely(HandbotRope& rope, const SafeStopMoment&) {
  rope.winding_speed = 0.0;
  return true;
}

// As they are.
bool stopSafely(FootbotGripper&, const SafeStopMoment&) { return true; }
bool stopSafely(EyebotMagnet&, const SafeStopMoment&) { return true; }
bool stopSafely(HandbotArms&, const SafeStopMoment&) { return true; }
bool stopSafely(HandbotHands&, const SafeStopMoment&) { return true; }
bool stopSafely(FootbotLeds&, const SafeStopMoment&) { return true; }
bool stopSafely(EyebotLeds&, const SafeStopMoment&) { return true; }

REGISTER_SAFE_STOP(FootbotWheels)
REGISTER_SAFE_STOP(FootbotTurret)
REGISTER_SAFE_STOP(FootbotGripper)
REGISTER_SAFE_STOP(FootbotLeds)
REGISTER_SAFE_STOP(EyebotVelocity)
REGISTER_SAFE_STOP(EyebotLaser)
REGISTER_SAFE_STOP(EyebotMagnet)
REGISTER_SAFE_STOP(EyebotLeds)
REGISTER_SAFE_STOP(HandbotArms)
REGISTER_SAFE_STOP(HandbotHands)
REGISTER_SAFE_STOP(HandbotRope)

}  // namespace swarmanoid
