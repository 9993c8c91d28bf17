/// Converts the common parts of radios (devices/radio.hpp) to messages and back. Their topics are in headers of their
/// own.
#pragma once

#include <swarmanoid_msgs/RadioCommand.h>
#include <swarmanoid_msgs/RadioMessages.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/devices/messages.hpp"
#include "swarmanoid_interface/devices/radio.hpp"

namespace swarmanoid {

template <std::size_t byte_count>
void toMessage(const RadioCommand<byte_count>& command, swarmanoid_msgs::RadioCommand& message) {
  message.to = command.to;
  message.payload.assign(command.payload.begin(), command.payload.end());
  message.sends = command.sends;
}

template <std::size_t byte_count>
void fromMessage(const swarmanoid_msgs::RadioCommand& message, RadioCommand<byte_count>& command) {
  fromMessage(message.payload, command.payload);
  command.to = message.to;
  command.sends = message.sends != 0;
}

template <std::size_t byte_count>
void toMessage(const ReceivedMessages<RadioMessage<byte_count>>& readings, swarmanoid_msgs::RadioMessages& message) {
  writeReceived(readings, message.messages, [](const auto& from, auto& to) { to.sender = from.sender; });
  message.overflowed = readings.overflowed;
}

/// The messages are stored in `parts`. @tparam Received derives from ReceivedMessages of radio messages
template <class Received>
auto fromMessage(const swarmanoid_msgs::RadioMessages& message, Received& readings, VariableParts& parts)
    -> decltype(static_cast<void>(typename Received::Message{}.sender)) {
  readReceived(message.messages, readings, parts, [](const auto& from, auto& to) { to.sender = from.sender; });
  readings.overflowed = message.overflowed != 0;
}

}  // namespace swarmanoid
