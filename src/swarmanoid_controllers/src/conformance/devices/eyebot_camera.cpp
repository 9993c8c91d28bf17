// An eyebot's camera measures beacon and prey at their positions.
#include "../checks.hpp"

namespace swarmanoid::conformance {
namespace {

const ChecksRegistration eyebot_camera_checks(
    {EyebotCamera::kType, [](Bench& bench) -> std::vector<Check> { return {camera(bench, EyebotCamera::kType)}; },
     nullptr, nullptr, [](const Bench& bench) -> const ColorBlobs* { return bench.sensor<EyebotCamera>(); }});

}  // namespace
}  // namespace swarmanoid::conformance
