/// Actuators: the rings of coloured LEDs of footbots and eyebots.
///
/// LED 0 is straight ahead (the robot's x axis), the others follow counter-clockwise at equal angles. A black LED is
/// off.
#pragma once

#include <array>
#include <cstddef>

#include "swarmanoid_interface/color.hpp"

namespace swarmanoid {

struct FootbotLeds {
  static constexpr const char* kType = "footbot_leds";
  static constexpr std::size_t kCount = 12;

  std::array<Color, kCount> ring{};

  void setAll(Color color) { ring.fill(color); }
  bool isFinite() const { return true; }
};

struct EyebotLeds {
  static constexpr const char* kType = "eyebot_leds";
  static constexpr std::size_t kCount = 16;

  std::array<Color, kCount> ring{};

  void setAll(Color color) { ring.fill(color); }
  bool isFinite() const { return true; }
};

}  // namespace swarmanoid
