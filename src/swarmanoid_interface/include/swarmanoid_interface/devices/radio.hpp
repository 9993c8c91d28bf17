/// Common parts of radios: messages (messages.hpp) that pass through walls, carry the address of the sender, and may be
/// addressed to one robot. They do not give the position of the sender.
///
///     robot.actuator<Wifi>().send(payload, addressOf("fb_3"));
///     for (const WifiMessage& message : robot.sensor<WifiReceived>().messages) { ... message.sender ... }
///
/// A robot's address is derived from its name, so addresses need no configuration: a sender only needs the name of the
/// receiver, and a receiver can look up the name of a sender. On a robot the driver translates addresses.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "swarmanoid_interface/devices/messages.hpp"
#include "swarmanoid_interface/random.hpp"

namespace swarmanoid {

/// 48 bits, as in hardware addresses of radios (IEEE Std 802-2014, 8.2): the probability that any two of 10,000 robots
/// have the same address is 2e-7.
using RadioAddress = std::uint64_t;
constexpr RadioAddress kEverybody = 0;  ///< broadcast; not the address of any robot

/// The address of a robot. @param name Robot::name
inline RadioAddress addressOf(std::string_view name) {
  constexpr unsigned kBits = 48;
  const std::uint64_t hash = stableHash(name);
  const RadioAddress address = (hash ^ hash >> kBits) & ((std::uint64_t{1} << kBits) - 1);
  return address == kEverybody ? 1 : address;
}

/// The command of a radio. @tparam byte_count of each message
template <std::size_t byte_count>
struct RadioCommand : MessageCommand<byte_count> {
  RadioAddress to = kEverybody;  ///< the only receiver, or kEverybody

  void send(const typename MessageCommand<byte_count>::Payload& bytes, RadioAddress receiver = kEverybody) {
    MessageCommand<byte_count>::send(bytes);
    to = receiver;
  }
  void fallSilent() {
    MessageCommand<byte_count>::fallSilent();
    to = kEverybody;
  }
};

template <class Visitor, std::size_t byte_count>
void fields(Visitor& visit, RadioCommand<byte_count>& command) {
  fields(visit, static_cast<MessageCommand<byte_count>&>(command));
  visit(command.to, {"to", "", "address of the only receiver; 0: all robots"});
}

/// One message.
template <std::size_t byte_count>
struct RadioMessage {
  RadioAddress sender = kEverybody;  ///< its address
  typename MessageCommand<byte_count>::Payload payload{};

  /// Does nothing: a radio does not measure the position of a sender. @param offset to its antenna
  void measure(const Eigen::Vector3d& /*offset*/) {}
};

template <class Visitor, std::size_t byte_count>
void fields(Visitor& visit, RadioMessage<byte_count>& message) {
  visit(message.sender, {"sender", "", "its address, by which it can be answered"});
  visit(message.payload, {"payload", "", "the bytes that were sent"});
}

}  // namespace swarmanoid
