// An eyebot's LEDs are shown to an observer.
#include "../checks.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::conformance {
namespace {

const ChecksRegistration eyebot_leds_checks({EyebotLeds::kType, [](Bench& bench) -> std::vector<Check> {
                                               return {ledsShown<EyebotLeds>(bench)};
                                             }});

}  // namespace
}  // namespace swarmanoid::conformance
