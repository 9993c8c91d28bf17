/// Actuator: the ring of coloured LEDs of a handbot, around its rope launcher. It is modelled on that of footbots
/// (leds.hpp), since the thesis does not mention LEDs of a handbot.
#pragma once

#include <array>
#include <cstddef>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

struct HandbotLeds {
  static constexpr const char* kType = "handbot_leds";
  static constexpr const char* kRobot = "handbot";
  static constexpr std::size_t kCount = 12;

  std::array<Color, kCount> ring{};

  void setAll(Color color) { ring.fill(color); }
};

template <class Visitor>
void fields(Visitor& visit, HandbotLeds& leds) {
  visit(leds.ring,
        {"ring", "", "LED 0 is ahead, the next ones follow counter-clockwise every 30 degrees; black is off"});
}
/// The LEDs keep their colours.
inline bool stopSafely(HandbotLeds& /*leds*/, const SafeStopMoment& /*moment*/) { return true; }
REGISTER_DEVICE_OF_SUITE(HandbotLeds, kActuator, "The ring of coloured LEDs.")

}  // namespace swarmanoid
