// Other commands for a footbot's ring of LEDs are shown to an observer: one colour, or a direction.
#include <cmath>
#include <type_traits>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/footbot_beacon.hpp"
#include "swarmanoid_interface/devices/footbot_preferential_direction.hpp"
#include "swarmanoid_interface/devices/led_array.hpp"

namespace swarmanoid::conformance {
namespace {

template <class Device>
std::vector<Check> ringChecks(Bench& bench) {
  if (!bench.isListed(Device::kType)) {
    return {};
  }
  return {ringShown<Device>(bench, [](Device& ring) {
    if constexpr (std::is_same_v<Device, FootbotBeacon>) {
      ring.color = kOneColor;
    } else {
      ring.setAll(kOneColor);
    }
  })};
}

/// Shows red ahead, blue to the left, green behind, one after the other: the observer remembers the colours.
std::vector<Check> directionChecks(Bench& bench) {
  using Direction = FootbotPreferentialDirection;
  if (!bench.isListed(Direction::kType)) {
    return {};
  }
  const auto show = [&bench](double direction, Color color) {
    return [&bench, direction, color] { bench.actuator<Direction>()->show(direction, color); };
  };
  Check check = shown(bench, Direction::kType, show(0.0, colors::kRed));
  check.stages.push_back(check.stages[0]);
  check.stages.push_back(check.stages[0]);
  check.stages[1].begin = show(M_PI / 2.0, colors::kBlue);
  check.stages[2].begin = show(M_PI, colors::kGreen);
  return {check};
}

const ChecksRegistration beacon_checks({FootbotBeacon::kType, ringChecks<FootbotBeacon>});
const ChecksRegistration direction_checks({FootbotPreferentialDirection::kType, directionChecks});
const ChecksRegistration any_leds_checks({Leds::kType, ringChecks<Leds>});

}  // namespace
}  // namespace swarmanoid::conformance
