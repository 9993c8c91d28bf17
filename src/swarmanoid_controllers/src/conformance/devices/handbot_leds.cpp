// A handbot's LEDs are shown to an observer.
#include "swarmanoid_interface/devices/handbot_leds.hpp"
#include "../checks.hpp"

namespace swarmanoid::conformance {
namespace {

const ChecksRegistration handbot_leds_checks({HandbotLeds::kType, [](Bench& bench) -> std::vector<Check> {
                                                return {ledsShown<HandbotLeds>(bench)};
                                              }});

}  // namespace
}  // namespace swarmanoid::conformance
