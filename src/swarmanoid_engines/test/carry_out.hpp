/// Stand-in for devices in tests of engines, which link none: sets the commands of mechanisms from the bank of
/// actuation, as the actuators of the suite do.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::test {

inline void commandHolder(Space& space, Row row, const std::string& name, bool holds, double winding_speed = 0.0) {
  const int index = space.entities.model[row]->findHolder(name);
  if (index >= 0) {
    space.holder_commands[row][static_cast<std::size_t>(index)] = {true, holds, winding_speed};
  }
}

inline void commandJoint(Space& space, Row row, const std::string& name, const JointCommand& command) {
  const int index = space.entities.model[row]->findJoint(name);
  if (index >= 0) {
    space.joint_commands[row][static_cast<std::size_t>(index)] = command;
  }
}

inline JointCommand toCommand(const FootbotTurret& turret) {
  switch (turret.mode) {
    case FootbotTurret::Mode::kAngle:
      return {JointCommand::Mode::kAngle, turret.angle};
    case FootbotTurret::Mode::kSpeed:
      return {JointCommand::Mode::kSpeed, turret.speed};
    case FootbotTurret::Mode::kPassive:
      break;
  }
  return {JointCommand::Mode::kPassive, 0.0};
}

inline void carryOut(Space& space, Row row) {
  const Banks& devices = space.actuation;
  if (const auto* wheels = devices.find<FootbotWheels>(row)) {
    space.wheels[row] = {true, wheels->left, wheels->right};
  }
  if (const auto* velocity = devices.find<EyebotVelocity>(row)) {
    space.flight[row] = {true, velocity->linear, velocity->yaw_rate};
  }
  if (const auto* gripper = devices.find<FootbotGripper>(row)) {
    commandHolder(space, row, "gripper", gripper->closed);
  }
  if (const auto* turret = devices.find<FootbotTurret>(row)) {
    commandJoint(space, row, "turret", toCommand(*turret));
  }
  if (const auto* magnet = devices.find<EyebotMagnet>(row)) {
    commandHolder(space, row, "magnet", magnet->on);
  }
  if (const auto* hands = devices.find<HandbotHands>(row)) {
    commandHolder(space, row, "left hand", hands->left);
    commandHolder(space, row, "right hand", hands->right);
  }
  if (const auto* rope = devices.find<HandbotRope>(row)) {
    commandHolder(space, row, "rope", rope->shot, rope->winding_speed);
  }
  if (const auto* arms = devices.find<HandbotArms>(row)) {
    const std::array<double, HandbotArmsState::kJoints> angles{arms->left.shoulder, arms->left.elbow,
                                                               arms->left.wrist,    arms->right.shoulder,
                                                               arms->right.elbow,   arms->right.wrist};
    for (std::size_t i = 0; i < angles.size(); ++i) {
      commandJoint(space, row, HandbotArmsState::kNames[i], {JointCommand::Mode::kAngle, angles[i]});
    }
  }
}

inline void carryOut(Space& space) {
  for (const Row row : space.entities.order) {
    carryOut(space, row);
  }
}

/// Devices with the mechanisms that the plugins of the suite declare.
inline std::vector<DeviceUse> uses(const std::vector<std::string>& devices) {
  using Kind = Mechanism::Kind;
  static const std::map<std::string, std::vector<Mechanism>> mechanisms{
      {FootbotWheels::kType, {{Kind::kWheels}}},
      {EyebotVelocity::kType, {{Kind::kFlight}}},
      {FootbotGripper::kType, {{Kind::kHolder, "gripper"}}},
      {FootbotTurret::kType, {{Kind::kJoint, "turret"}}},
      {FootbotTurretState::kType, {{Kind::kJoint, "turret"}}}};
  std::vector<DeviceUse> result;
  for (const std::string& device : devices) {
    const auto found = mechanisms.find(device);
    const auto* type = findDeviceType(device);
    result.push_back({device, found == mechanisms.end() ? std::vector<Mechanism>{} : found->second,
                      type == nullptr ? DeviceKind::kSensor : type->kind});
  }
  return result;
}

}  // namespace swarmanoid::test
