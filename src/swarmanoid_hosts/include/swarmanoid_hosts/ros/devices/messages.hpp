/// Converts what all devices of devices/messages.hpp share to messages and back. Their topics are in headers of their
/// own.
#pragma once

#include <swarmanoid_msgs/MessageCommand.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "swarmanoid_interface/devices/messages.hpp"

namespace swarmanoid {

/// Bytes that are missing are 0. @throws std::runtime_error for more bytes than the device sends
template <std::size_t byte_count>
void fromMessage(const std::vector<std::uint8_t>& bytes, std::array<std::uint8_t, byte_count>& payload) {
  if (bytes.size() > byte_count) {
    throw std::runtime_error("found a payload of " + std::to_string(bytes.size()) + " bytes, allowed: at most " +
                             std::to_string(byte_count));
  }
  payload = {};
  std::copy(bytes.begin(), bytes.end(), payload.begin());
}

template <std::size_t byte_count>
void toMessage(const MessageCommand<byte_count>& command, swarmanoid_msgs::MessageCommand& message) {
  message.payload.assign(command.payload.begin(), command.payload.end());
  message.sends = command.sends;
}

template <std::size_t byte_count>
void fromMessage(const swarmanoid_msgs::MessageCommand& message, MessageCommand<byte_count>& command) {
  fromMessage(message.payload, command.payload);
  command.sends = message.sends != 0;
}

}  // namespace swarmanoid
