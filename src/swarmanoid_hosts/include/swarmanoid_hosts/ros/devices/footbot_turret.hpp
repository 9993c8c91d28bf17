/// Defines the topics of devices/footbot_turret.hpp, and converts its devices to messages and back.
#pragma once

#include <sensor_msgs/JointState.h>
#include <swarmanoid_msgs/TurretCommand.h>

#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"

namespace swarmanoid {

inline void toMessage(const FootbotTurret& command, swarmanoid_msgs::TurretCommand& message) {
  message.mode = static_cast<std::uint8_t>(command.mode);
  message.angle = command.angle;
  message.speed = command.speed;
}

inline void fromMessage(const swarmanoid_msgs::TurretCommand& message, FootbotTurret& command) {
  if (message.mode > swarmanoid_msgs::TurretCommand::PASSIVE) {
    throw std::runtime_error("found mode " + std::to_string(message.mode) +
                             ", allowed: 0 (ANGLE), 1 (SPEED), 2 (PASSIVE)");
  }
  command = {static_cast<FootbotTurret::Mode>(message.mode), message.angle, message.speed};
}

/// The message has one joint, `turret`.
inline void toMessage(const FootbotTurretState& readings, sensor_msgs::JointState& message) {
  message.name.assign(1, "turret");
  message.position.assign(1, readings.angle);
  message.velocity.assign(1, readings.speed);
  message.effort.assign(1, readings.torque);
}

inline void fromMessage(const sensor_msgs::JointState& message, FootbotTurretState& readings) {
  const JointValues joint = jointOf(message, "turret");
  readings = {joint.position, joint.velocity, joint.effort};
}

REGISTER_DEVICE_TOPIC(FootbotTurret, swarmanoid_msgs::TurretCommand, kCommand, "turret/command")
REGISTER_DEVICE_TOPIC(FootbotTurretState, sensor_msgs::JointState, kReading, "turret/state", "base_link")

}  // namespace swarmanoid
