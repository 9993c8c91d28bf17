/// What devices that carry messages between robots have in common: infrared boards, and radios (radio.hpp). There are
/// two devices of each: an actuator, which sends, and a sensor, which has what others sent.
///
///     struct MyRadio : MessageCommand<100> { static constexpr const char* kType = ...; };
///     struct MyRadioReceived : ReceivedMessages<MyRadioMessage> { static constexpr const char* kType = ...; };
///
/// A robot that sends says its payload once in each tick, to all who hear it. A message that is sent in tick k is read
/// in tick k + 1, and in no other: who sends one message falls silent in the tick after.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// Writes a colour into three bytes of a payload: red, green, blue. So robots say what their LEDs show.
/// @param place of the first byte @pre the payload has all three
template <std::size_t byte_count>
void putColor(std::array<std::uint8_t, byte_count>& payload, std::size_t place, Color color) {
  SWARMANOID_EXPECTS(place + 3 <= byte_count);
  payload[place] = color.red;
  payload[place + 1] = color.green;
  payload[place + 2] = color.blue;
}

/// @param place of the first byte, as for putColor @pre the payload has all three
template <std::size_t byte_count>
Color colorAt(const std::array<std::uint8_t, byte_count>& payload, std::size_t place) {
  SWARMANOID_EXPECTS(place + 3 <= byte_count);
  return {payload[place], payload[place + 1], payload[place + 2]};
}

/// The command of a device that sends: silent at rest, which is its safe stop too. What the bytes mean is the
/// controllers' affair. @tparam byte_count of each message
template <std::size_t byte_count>
struct MessageCommand {
  static constexpr std::size_t kBytes = byte_count;
  using Payload = std::array<std::uint8_t, byte_count>;

  Payload payload{};
  bool sends = false;  ///< whether it says its payload in this tick, and in each one until this changes

  void send(const Payload& bytes) {
    payload = bytes;
    sends = true;
  }
  void fallSilent() {
    payload = {};
    sends = false;
  }
};

template <class Visitor, std::size_t byte_count>
void fields(Visitor& visit, MessageCommand<byte_count>& command) {
  visit(command.payload, {"payload", "", "the bytes of the message; what they mean, controllers agree on"});
  visit(command.sends, {"sends", "", "whether it sends them, in each tick until this changes"});
}

/// The readings of a device that receives: the messages of the last tick, in the order of their senders' entity
/// numbers. If more come in than there are slots, the nearest senders' are reported, in the same order. The span is
/// valid until the next tick. @tparam OneMessage has `payload`, the sender's, and what the device measures of a sender
template <class OneMessage>
struct ReceivedMessages {
  using Message = OneMessage;
  static constexpr std::size_t kMostMessages = 64;
  /// A struct that derives from this says so if what is in the air for others takes slots too, as on a radio's channel.
  static constexpr bool kSharesChannel = false;
  static constexpr double kUsualLossAtRange = 0.0;  ///< probability; likewise

  Span<const Message> messages;
  bool overflowed = false;  ///< more came in than there are slots; the farthest are left out (and an event reports it)
};

template <class Visitor, class OneMessage>
void fields(Visitor& visit, ReceivedMessages<OneMessage>& received) {
  visit(received.messages, {"messages"});
  visit(received.overflowed, {"overflowed", "", "more came in than there are slots; the farthest are left out"});
}

}  // namespace swarmanoid
