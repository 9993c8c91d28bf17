/// What a robot that is tested and its partner say to each other, by any device that carries messages.
///
/// The robot calls its partner by name; the partner, an observer, answers with the same bytes, each bit turned over,
/// whatever it hears that is a call for it. So a byte that is lost, added or moved on either way is found, and nobody
/// takes a call for an answer. What robots say to others is in order too, and ignored.
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
constexpr std::size_t kPartner = 1;  // where the name of the partner begins, behind the mark
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

/// @param count of the call, so that each differs from the one before
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

/// Whether these words, of any caller, are a call for that partner, and all of it.
template <std::size_t byte_count>
bool isCallFor(const Words<byte_count>& words, const std::string& partner) {
  Words<byte_count> expected = callOf<byte_count>("", partner, words[talk::kCount]);
  for (std::size_t i = 0; i < talk::kNameBytes; ++i) {
    expected[talk::kCaller + i] = words[talk::kCaller + i];
  }
  return words == expected;
}

/// What an observer says by radio to nobody, when it has no call to answer: no other robot may hear it.
template <std::size_t byte_count>
Words<byte_count> whisper() {
  Words<byte_count> words{};
  words.fill(talk::kWhisper);
  return words;
}

}  // namespace swarmanoid::conformance
