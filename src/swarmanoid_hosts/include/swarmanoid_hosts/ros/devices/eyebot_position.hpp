/// Defines the topics of devices/eyebot_position.hpp, and converts its device to messages and back.
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <swarmanoid_msgs/FlightCommand.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/eyebot_position.hpp"

namespace swarmanoid {

inline void toMessage(const EyebotPosition& command, swarmanoid_msgs::FlightCommand& message) {
  message.mode = static_cast<std::uint8_t>(command.mode);
  message.x = command.position.x();
  message.y = command.position.y();
  message.z = command.position.z();
  message.yaw = command.yaw;
}

inline void fromMessage(const swarmanoid_msgs::FlightCommand& message, EyebotPosition& command) {
  if (message.mode > swarmanoid_msgs::FlightCommand::LAND) {
    throw std::runtime_error("found mode " + std::to_string(message.mode) +
                             ", allowed: 0 (HOVER), 1 (TAKE_OFF), 2 (GO_TO), 3 (LAND)");
  }
  command.mode = static_cast<EyebotPosition::Mode>(message.mode);
  command.position = {message.x, message.y, message.z};
  command.yaw = message.yaw;
}

/// A pose has no modes: every command is sent as a command to go to its position.
inline void toMessage(const EyebotPosition& command, geometry_msgs::PoseStamped& message) {
  message.pose.position.x = command.position.x();
  message.pose.position.y = command.position.y();
  message.pose.position.z = command.position.z();
  message.pose.orientation.z = std::sin(0.5 * command.yaw);
  message.pose.orientation.w = std::cos(0.5 * command.yaw);
}

/// Commands the mode kGoTo. The only frame is that of the take-off: the frame_id is "", "takeoff", or ends in
/// "/takeoff". The orientation must be a turn about z.
inline void fromMessage(const geometry_msgs::PoseStamped& message, EyebotPosition& command) {
  const std::string& frame = message.header.frame_id;
  if (!frame.empty() && frame.substr(frame.rfind('/') + 1) != "takeoff") {
    throw std::runtime_error("found the frame '" + frame + "', allowed: none, or that of the take-off, 'takeoff'");
  }
  const auto& orientation = message.pose.orientation;
  refuseUnlessZero("orientation.x", orientation.x);
  refuseUnlessZero("orientation.y", orientation.y);
  if (orientation.z == 0.0 && orientation.w == 0.0) {
    throw std::runtime_error("found an orientation of length 0, allowed: a turn about z, such as w = 1 for none");
  }
  command.goTo({message.pose.position.x, message.pose.position.y, message.pose.position.z},
               wrapAngle(2.0 * std::atan2(orientation.z, orientation.w)));
}

REGISTER_DEVICE_TOPIC(EyebotPosition, swarmanoid_msgs::FlightCommand, kCommand, "flight/command")
REGISTER_DEVICE_TOPIC(EyebotPosition, geometry_msgs::PoseStamped, kCommand, "command/pose")

}  // namespace swarmanoid
