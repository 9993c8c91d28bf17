/// Converts the common parts of the devices of devices/messages.hpp to messages and back. Their topics are in headers
/// of their own.
#pragma once

#include <swarmanoid_msgs/MessageCommand.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/devices/messages.hpp"

namespace swarmanoid {

/// Missing bytes are 0. @throws std::runtime_error for more bytes than the device sends
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

/// Writes the received messages. @param write (const one of the device's messages&, one of the list&): all but its
/// payload
template <class Readings, class List, class Write>
void writeReceived(const Readings& readings, List& list, const Write& write) {
  list.resize(readings.messages.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto& from = readings.messages[i];
    write(from, list[i]);
    list[i].payload.assign(from.payload.begin(), from.payload.end());
  }
}

/// The inverse; the messages are stored in `parts`. @param read (const one of the list&, one of the device's
/// messages&): all but its payload @throws std::runtime_error
template <class Readings, class List, class Read>
void readReceived(const List& list, Readings& readings, VariableParts& parts, const Read& read) {
  using Message = typename Readings::Message;
  if (list.size() > Readings::kMostMessages) {
    throw std::runtime_error("found " + std::to_string(list.size()) + " messages, allowed: at most " +
                             std::to_string(Readings::kMostMessages));
  }
  parts.clear();
  Message* messages = parts.room<Message>(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    read(list[i], messages[i]);
    fromMessage(list[i].payload, messages[i].payload);
  }
  readings.messages = Span<const Message>(messages, list.size());
}

}  // namespace swarmanoid
