// A footbot's LEDs are shown to an observer.
#include "../checks.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::conformance {
namespace {

const ChecksRegistration footbot_leds_checks({FootbotLeds::kType, [](Bench& bench) -> std::vector<Check> {
                                                return {ledsShown<FootbotLeds>(bench)};
                                              }});

}  // namespace
}  // namespace swarmanoid::conformance
