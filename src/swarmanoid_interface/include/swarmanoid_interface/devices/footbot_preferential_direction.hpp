/// Actuator: a direction that a footbot shows to others by its ring of LEDs (thesis 3.3, "displaying a preferential
/// direction"). It is the ring of FootbotLeds, commanded in another way, so a robot has one of the two.
#pragma once

#include <cmath>
#include <cstddef>

#include "swarmanoid_interface/color.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// At rest all LEDs are off.
struct FootbotPreferentialDirection {
  static constexpr const char* kType = "footbot_preferential_direction";
  static constexpr const char* kRobot = "footbot";

  double direction = 0.0;  ///< in the robot's frame [rad], counter-clockwise from ahead
  Color color;             ///< of the three LEDs nearest to it
  Color other_color;       ///< of the others

  void show(double where, Color there, Color elsewhere = colors::kBlack) {
    direction = where;
    color = there;
    other_color = elsewhere;
  }

  /// Returns the colour of one LED. @param led index in the ring; LED 0 is ahead @param count LEDs of the ring, at
  /// equal angles
  Color colorOf(std::size_t led, std::size_t count) const {
    const auto number = static_cast<double>(count);
    // with two equally near LEDs, the one further counter-clockwise is the middle
    const double middle = std::floor(direction / (2.0 * M_PI) * number + 0.5);
    const double beside = std::remainder(static_cast<double>(led) - middle, number);
    return std::abs(beside) <= 1.0 ? color : other_color;
  }
};

template <class Visitor>
void fields(Visitor& visit, FootbotPreferentialDirection& shown) {
  visit(shown.direction, {"direction", "rad", "in the robot's frame, counter-clockwise from ahead"});
  visit(shown.color, {"color", "", "of the three LEDs nearest to the direction; black is off"});
  visit(shown.other_color, {"other_color", "", "of the other LEDs; black is off"});
}
/// The LEDs keep their colours.
inline bool stopSafely(FootbotPreferentialDirection& /*shown*/, const SafeStopMoment& /*moment*/) { return true; }
REGISTER_DEVICE_OF_SUITE(FootbotPreferentialDirection, kActuator, "A direction, shown by the ring of LEDs.")

}  // namespace swarmanoid
