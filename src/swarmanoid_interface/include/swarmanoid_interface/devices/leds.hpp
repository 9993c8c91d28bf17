/// Actuators: the rings of coloured LEDs of footbots and eyebots.
///
/// LED 0 is straight ahead (the robot's x axis), the others follow counter-clockwise at equal angles. A black LED is
/// off.
#pragma once

#include <array>
#include <cstddef>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

struct FootbotLeds {
  static constexpr const char* kType = "footbot_leds";
  static constexpr const char* kRobot = "footbot";
  static constexpr std::size_t kCount = 12;

  std::array<Color, kCount> ring{};

  void setAll(Color color) { ring.fill(color); }
};

template <class Visitor>
void fields(Visitor& visit, FootbotLeds& leds) {
  visit(leds.ring,
        {"ring", "", "LED 0 is ahead, the next ones follow counter-clockwise every 30 degrees; black is off"});
}
/// The LEDs keep their colours.
inline bool stopSafely(FootbotLeds& /*leds*/, const SafeStopMoment& /*moment*/) { return true; }
REGISTER_DEVICE_OF_SUITE(FootbotLeds, kActuator, "The ring of coloured LEDs.")

struct EyebotLeds {
  static constexpr const char* kType = "eyebot_leds";
  static constexpr const char* kRobot = "eyebot";
  static constexpr std::size_t kCount = 16;

  std::array<Color, kCount> ring{};

  void setAll(Color color) { ring.fill(color); }
};

template <class Visitor>
void fields(Visitor& visit, EyebotLeds& leds) {
  visit(leds.ring,
        {"ring", "", "LED 0 is ahead, the next ones follow counter-clockwise every 22.5 degrees; black is off"});
}
/// The LEDs keep their colours.
inline bool stopSafely(EyebotLeds& /*leds*/, const SafeStopMoment& /*moment*/) { return true; }
REGISTER_DEVICE_OF_SUITE(EyebotLeds, kActuator, "The ring of coloured LEDs.")

}  // namespace swarmanoid
