/// Words that the carriers and the carried robot send each other by WiFi: one word in the first byte, in each tick
/// while it holds.
#pragma once

#include <cstdint>

#include "swarmanoid_interface/devices/wifi.hpp"

namespace swarmanoid {

enum class CarryingWord : std::uint8_t {
  kNone,
  kGripping,  ///< carrier without a grip yet; the others wait for it
  kHolding,   ///< carrier that has gripped
  kArrived    ///< carried robot that has reached its target
};

inline void say(Wifi& wifi, CarryingWord word) { wifi.send({static_cast<std::uint8_t>(word)}); }

/// Whether a word was received in the last tick.
inline bool isHeard(const WifiReceived& received, CarryingWord word) {
  for (const WifiMessage& message : received.messages) {
    if (message.payload[0] == static_cast<std::uint8_t>(word)) {
      return true;
    }
  }
  return false;
}

}  // namespace swarmanoid
