/// Defines the topics of devices/handbot_arms.hpp, and converts its devices to messages and back.
#pragma once

#include <sensor_msgs/JointState.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"

namespace swarmanoid {

namespace detail {

/// Returns the joints in the order of HandbotArmsState::kNames.
template <class Arms>
auto anglesOf(Arms& arms) {
  return std::array{&arms.left.shoulder,  &arms.left.elbow,  &arms.left.wrist,
                    &arms.right.shoulder, &arms.right.elbow, &arms.right.wrist};
}

}  // namespace detail

/// The message contains joints by name, with positions.
inline void toMessage(const HandbotArms& command, sensor_msgs::JointState& message) {
  message.name.assign(HandbotArmsState::kNames.begin(), HandbotArmsState::kNames.end());
  message.position.clear();
  for (const double* angle : detail::anglesOf(command)) {
    message.position.push_back(*angle);
  }
}

/// Joints that the message does not name keep their command.
inline void fromMessage(const sensor_msgs::JointState& message, HandbotArms& command) {
  const auto& names = HandbotArmsState::kNames;
  if (message.position.size() != message.name.size()) {
    throw std::runtime_error("found " + std::to_string(message.position.size()) + " positions, expected " +
                             std::to_string(message.name.size()) + ", one for each name");
  }
  for (std::size_t i = 0; i < message.name.size(); ++i) {
    const auto found = std::find(names.begin(), names.end(), message.name[i]);
    if (found == names.end()) {
      const std::vector<std::string> known(names.begin(), names.end());
      throw std::runtime_error("found joint '" + message.name[i] + "', allowed: " + joinNames(known) +
                               didYouMean(message.name[i], known));
    }
    *detail::anglesOf(command)[static_cast<std::size_t>(found - names.begin())] = message.position[i];
  }
}

inline void toMessage(const HandbotArmsState& readings, sensor_msgs::JointState& message) {
  message.name.assign(HandbotArmsState::kNames.begin(), HandbotArmsState::kNames.end());
  message.position.resize(HandbotArmsState::kJoints);
  message.velocity.resize(HandbotArmsState::kJoints);
  message.effort.resize(HandbotArmsState::kJoints);
  for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
    message.position[i] = readings.joints[i].angle;
    message.velocity[i] = readings.joints[i].speed;
    message.effort[i] = readings.joints[i].effort;
  }
}

/// Accepts any order of joints; joints other than the arms' are ignored, and all of the arms' must be present.
inline void fromMessage(const sensor_msgs::JointState& message, HandbotArmsState& readings) {
  for (std::size_t i = 0; i < HandbotArmsState::kJoints; ++i) {
    const JointValues joint = jointOf(message, HandbotArmsState::kNames[i]);
    readings.joints[i] = {joint.position, joint.velocity, joint.effort};
  }
}

REGISTER_DEVICE_TOPIC(HandbotArms, sensor_msgs::JointState, kCommand, "arms/command")
REGISTER_DEVICE_TOPIC(HandbotArmsState, sensor_msgs::JointState, kReading, "joint_states", "base_link")

}  // namespace swarmanoid
