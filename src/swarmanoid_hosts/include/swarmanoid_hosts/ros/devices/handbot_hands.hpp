/// Defines the topics of devices/handbot_hands.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/HandsCommand.h>
#include <swarmanoid_msgs/HandsState.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"

namespace swarmanoid {

inline void toMessage(const HandbotHands& command, swarmanoid_msgs::HandsCommand& message) {
  message.left = command.left;
  message.right = command.right;
}

inline void fromMessage(const swarmanoid_msgs::HandsCommand& message, HandbotHands& command) {
  command = {message.left != 0, message.right != 0};
}

inline void toMessage(const HandbotHandsState& readings, swarmanoid_msgs::HandsState& message) {
  message.left_holding = readings.left.holding;
  message.left_force = readings.left.force;
  message.right_holding = readings.right.holding;
  message.right_force = readings.right.force;
}

inline void fromMessage(const swarmanoid_msgs::HandsState& message, HandbotHandsState& readings) {
  readings.left = {message.left_holding != 0, message.left_force};
  readings.right = {message.right_holding != 0, message.right_force};
}

REGISTER_DEVICE_TOPIC(HandbotHands, swarmanoid_msgs::HandsCommand, kCommand, "hands/command")
REGISTER_DEVICE_TOPIC(HandbotHandsState, swarmanoid_msgs::HandsState, kReading, "hands/state", "base_link")

}  // namespace swarmanoid
