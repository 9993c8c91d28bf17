/// Common parts of devices that carry messages between robots: infrared boards, and radios (radio.hpp). Each consists
/// of two devices: an actuator, which sends, and a sensor, which holds the received messages.
///
///     struct MyRadio : MessageCommand<100> { static constexpr const char* kType = ...; };
///     struct MyRadioReceived : ReceivedMessages<MyRadioMessage> { static constexpr const char* kType = ...; };
///
/// A sender transmits its payload once in each tick, to all receivers in range. A message sent in tick k is read in
/// tick k + 1 only. To send a single message, call fallSilent in the next tick.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/span.hpp"

namespace swarmanoid {

/// Writes a colour into three bytes of a payload: red, green, blue, for example that of the robot's LEDs.
/// @param place of the first byte @pre the payload has all three bytes
template <std::size_t byte_count>
void putColor(std::array<std::uint8_t, byte_count>& payload, std::size_t place, Color color) {
  SWARMANOID_EXPECTS(place + 3 <= byte_count);
  payload[place] = color.red;
  payload[place + 1] = color.green;
  payload[place + 2] = color.blue;
}

/// @param place of the first byte, as for putColor @pre the payload has all three bytes
template <std::size_t byte_count>
Color colorAt(const std::array<std::uint8_t, byte_count>& payload, std::size_t place) {
  SWARMANOID_EXPECTS(place + 3 <= byte_count);
  return {payload[place], payload[place + 1], payload[place + 2]};
}

/// The command of a sending device: silent at rest, which is its safe stop too. Controllers define the meaning of the
/// bytes. @tparam byte_count of each message
template <std::size_t byte_count>
struct MessageCommand {
  static constexpr std::size_t kBytes = byte_count;
  using Payload = std::array<std::uint8_t, byte_count>;

  Payload payload{};
  bool sends = false;  ///< sends the payload in each tick while true

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
  visit(command.payload, {"payload", "", "the bytes of the message; controllers define their meaning"});
  visit(command.sends, {"sends", "", "whether it sends them, in each tick until this changes"});
}

/// The readings of a device that receives: the messages of the last tick, in the order of their senders' entity
/// numbers. If there are more messages than slots, those of the nearest senders are reported, in the same order. The
/// span is valid until the next tick. @tparam OneMessage has the sender's `payload`, and the device's measurements of
/// the sender
template <class OneMessage>
struct ReceivedMessages {
  using Message = OneMessage;
  static constexpr std::size_t kMostMessages = 64;
  /// Derived structs set this if messages addressed to other robots take slots too, as on a radio channel.
  static constexpr bool kSharesChannel = false;
  /// Probability of loss at maximum range; derived structs may set another one.
  static constexpr double kUsualLossAtRange = 0.0;

  Span<const Message> messages;
  bool overflowed = false;  ///< more messages than slots arrived; the farthest are left out (and an event reports it)
};

template <class Visitor, class OneMessage>
void fields(Visitor& visit, ReceivedMessages<OneMessage>& received) {
  visit(received.messages, {"messages"});
  visit(received.overflowed, {"overflowed", "", "more came in than there are slots; the farthest are left out"});
}

}  // namespace swarmanoid
