/// Actuator: the coloured LEDs of any robot.
#pragma once

#include <array>
#include <cstddef>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Colours in the order of the LEDs: that of the robot's description. A black LED is off; colours beyond the number of
/// LEDs of the robot are ignored.
struct Leds {
  static constexpr const char* kType = "leds";
  static constexpr std::size_t kMost = 64;

  std::array<Color, kMost> colors{};

  void setAll(Color color) { colors.fill(color); }
};

template <class Visitor>
void fields(Visitor& visit, Leds& leds) {
  visit(leds.colors,
        {"colors", "", "in the order of the description; black is off; colours beyond the robot's LEDs are ignored"});
}
/// The LEDs keep their colours.
inline bool stopSafely(Leds& /*leds*/, const SafeStopMoment& /*moment*/) { return true; }
REGISTER_DEVICE_OF_SUITE(Leds, kActuator, "Coloured LEDs, as many as the robot has.")

}  // namespace swarmanoid
