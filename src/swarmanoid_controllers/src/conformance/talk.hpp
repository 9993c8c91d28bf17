/// Messages between a tested robot and its partner, by any device that carries messages.
///
/// The robot calls its partner by name; the partner, an observer, answers each call to it with the same bytes, all bits
/// inverted. A byte that is lost, added or moved on either way is therefore detected, and a call is never mistaken for
/// an answer. Messages between other robots are legal, and ignored.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "swarmanoid_interface/devices/radio.hpp"

namespace swarmanoid::conformance {

template <std::size_t byte_count>
using Words = std::array<std::uint8_t, byte_count>;

namespace talk {

constexpr std::size_t kNameBytes = 3;
constexpr std::size_t kPartner = 1;  // offset of the partner's name, after the mark
constexpr std::size_t kCaller = kPartner + kNameBytes;
constexpr std::size_t kCount = kCaller + kNameBytes;
constexpr std::uint8_t kCall = 0xC5;
constexpr std::uint8_t kWhisper = 0x71;

template <std::size_t byte_count>
void putName(Words<byte_count>& words, std::size_t at, const std::string& name) {
  const RadioAddress address = addressOf(name);
  for (std::size_t i = 0; i < kNameBytes; ++i) {
    words[at + i] = static_cast<std::uint8_t>(address >> (8U * i));
  }
}

}  // namespace talk

/// @param count of the call, so that successive calls differ
template <std::size_t byte_count>
Words<byte_count> callOf(const std::string& caller, const std::string& partner, std::uint8_t count) {
  static_assert(byte_count > talk::kCount + 1);
  Words<byte_count> words{};
  words[0] = talk::kCall;
  talk::putName(words, talk::kPartner, partner);
  talk::putName(words, talk::kCaller, caller);
  words[talk::kCount] = count;
  for (std::size_t i = talk::kCount + 1; i < byte_count; ++i) {
    words[i] = static_cast<std::uint8_t>(37U * i + count);
  }
  return words;
}

template <std::size_t byte_count>
Words<byte_count> answerTo(Words<byte_count> call) {
  for (std::uint8_t& byte : call) {
    byte = static_cast<std::uint8_t>(~byte);
  }
  return call;
}

/// Whether these bytes are a complete call, of any caller, for that partner.
template <std::size_t byte_count>
bool isCallFor(const Words<byte_count>& words, const std::string& partner) {
  Words<byte_count> expected = callOf<byte_count>("", partner, words[talk::kCount]);
  for (std::size_t i = 0; i < talk::kNameBytes; ++i) {
    expected[talk::kCaller + i] = words[talk::kCaller + i];
  }
  return words == expected;
}

/// Message that an observer without a call to answer sends by radio to no address: no other robot may receive it.
template <std::size_t byte_count>
Words<byte_count> whisper() {
  Words<byte_count> words{};
  words.fill(talk::kWhisper);
  return words;
}

}  // namespace swarmanoid::conformance
