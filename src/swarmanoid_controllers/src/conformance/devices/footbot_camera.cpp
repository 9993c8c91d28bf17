// A footbot's camera measures beacon and prey at their positions.
#include "../checks.hpp"

namespace swarmanoid::conformance {
namespace {

const ChecksRegistration footbot_camera_checks(
    {FootbotCamera::kType, [](Bench& bench) -> std::vector<Check> { return {camera(bench, FootbotCamera::kType)}; },
     [](Surroundings& usual) {
       usual.beacon_distance = 1.0;
       usual.prey_distance = 0.5;
     },
     nullptr, [](const Bench& bench) -> const ColorBlobs* { return bench.sensor<FootbotCamera>(); }});

}  // namespace
}  // namespace swarmanoid::conformance
