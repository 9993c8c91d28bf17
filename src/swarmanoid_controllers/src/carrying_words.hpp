/// What robots that carry something together, and the robot that is carried, tell each other by WiFi: one word in the
/// first byte, in each tick while it holds.
#pragma once

#include <cstdint>

#include "swarmanoid_interface/devices/wifi.hpp"

namespace swarmanoid {

enum class CarryingWord : std::uint8_t {
  kNone,
  kGripping,  ///< a carrier that has no grip yet: wait for it
  kHolding,   ///< a carrier that has gripped
  kArrived    ///< who is carried: it is where it wants to be
};

inline void say(Wifi& wifi, CarryingWord word) { wifi.send({static_cast<std::uint8_t>(word)}); }

/// Whether anybody has said that word in the last tick.
inline bool isHeard(const WifiReceived& received, CarryingWord word) {
  for (const WifiMessage& message : received.messages) {
    if (message.payload[0] == static_cast<std::uint8_t>(word)) {
      return true;
    }
  }
  return false;
}

}  // namespace swarmanoid
