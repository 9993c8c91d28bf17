/// Defines the topics of devices/joints.hpp, and converts its devices to messages and back.
///
/// Devices identify joints by their order, not by their names, so these messages have no names: a message with names
/// could have another order.
#pragma once

#include <sensor_msgs/JointState.h>
#include <swarmanoid_msgs/JointsCommand.h>

#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/same_length.hpp"
#include "swarmanoid_interface/devices/joints.hpp"

namespace swarmanoid {

inline void toMessage(const Joints& command, swarmanoid_msgs::JointsCommand& message) {
  message.modes.clear();
  message.angles.clear();
  message.speeds.clear();
  for (const Joints::Joint& joint : command.joints) {
    message.modes.push_back(static_cast<std::uint8_t>(joint.mode));
    message.angles.push_back(joint.angle);
    message.speeds.push_back(joint.speed);
  }
}

/// Joints that the message does not include keep their commands.
inline void fromMessage(const swarmanoid_msgs::JointsCommand& message, Joints& command) {
  const std::size_t count = sameLength(
      {{"modes", message.modes.size()}, {"angles", message.angles.size()}, {"speeds", message.speeds.size()}},
      Joints::kMost);
  for (std::size_t i = 0; i < count; ++i) {
    if (message.modes[i] > swarmanoid_msgs::JointsCommand::PASSIVE) {
      throw std::runtime_error("found mode " + std::to_string(message.modes[i]) + " of joint " + std::to_string(i) +
                               ", allowed: 0 (ANGLE), 1 (SPEED), 2 (PASSIVE)");
    }
    command.joints[i] = {static_cast<Joints::Mode>(message.modes[i]), message.angles[i], message.speeds[i]};
  }
}

/// The message has no names.
inline void toMessage(const JointStates& readings, sensor_msgs::JointState& message) {
  message.name.clear();
  message.position.clear();
  message.velocity.clear();
  message.effort.clear();
  for (const JointStates::Joint& joint : readings.joints) {
    message.position.push_back(joint.angle);
    message.velocity.push_back(joint.speed);
    message.effort.push_back(joint.effort);
  }
}

/// The readings are stored in `parts`.
inline void fromMessage(const sensor_msgs::JointState& message, JointStates& readings, VariableParts& parts) {
  if (!message.name.empty()) {
    throw std::runtime_error("found " + std::to_string(message.name.size()) +
                             " names, allowed: none, joints are known by their order here");
  }
  const std::size_t count = sameLength({{"positions", message.position.size()},
                                        {"velocities", message.velocity.size()},
                                        {"efforts", message.effort.size()}},
                                       JointStates::kMost);
  parts.clear();
  auto* joints = parts.room<JointStates::Joint>(count);
  for (std::size_t i = 0; i < count; ++i) {
    joints[i] = {message.position[i], message.velocity[i], message.effort[i]};
  }
  readings.joints = Span<const JointStates::Joint>(joints, count);
}

REGISTER_DEVICE_TOPIC(Joints, swarmanoid_msgs::JointsCommand, kCommand, "joints/command")
REGISTER_DEVICE_TOPIC(JointStates, sensor_msgs::JointState, kReading, "joints/state", "base_link")

}  // namespace swarmanoid
