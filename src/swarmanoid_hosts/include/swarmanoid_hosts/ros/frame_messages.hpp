/// Converts between frames and messages, for the exchange between space and participants and for recordings.
#pragma once

#include <ros/serialization.h>
#include <swarmanoid_msgs/CommandFrame.h>
#include <swarmanoid_msgs/ControllerStart.h>
#include <swarmanoid_msgs/Register.h>
#include <swarmanoid_msgs/SensorFrame.h>

#include <map>
#include <string>

#include "swarmanoid_interface/frames.hpp"

namespace swarmanoid {

/// Maps the name of a parameter (for nested ones a path: outer/inner) to the place where it was given.
using ParameterLocations = std::map<std::string, SourceLocation>;

void toMessage(const SensorFrame& frame, swarmanoid_msgs::SensorFrame& message);
SensorFrame fromMessage(const swarmanoid_msgs::SensorFrame& message);

void toMessage(const CommandFrame& frame, swarmanoid_msgs::CommandFrame& message);
CommandFrame fromMessage(const swarmanoid_msgs::CommandFrame& message);

/// Converts messages to bytes and back, as topics do. @throws ros::serialization::StreamOverrunException if the bytes
/// are not one of these messages
template <class Message>
void toBytes(const Message& message, Bytes& bytes) {
  bytes.resize(ros::serialization::serializationLength(message));
  ros::serialization::OStream out(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(out, message);
}
template <class Message>
void fromBytes(const Bytes& bytes, Message& message) {
  ros::serialization::IStream in(const_cast<std::uint8_t*>(bytes.data()), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(in, message);
}

/// Converts all fields but `success` and `message`.
void toMessage(const Registration& registration, swarmanoid_msgs::Register::Response& message);
Registration fromMessage(const swarmanoid_msgs::Register::Response& message);

/// Converts one robot of the registration. The caller sets the stamp of the header.
void toMessage(const Registration& registration, std::size_t robot, swarmanoid_msgs::ControllerStart& message);
/// Returns the registration of one robot, in session 0.
/// @param elsewhere locations of the parameters that do not come from the location in the message
Registration fromMessage(const swarmanoid_msgs::ControllerStart& message, const ParameterLocations& elsewhere = {});

}  // namespace swarmanoid
