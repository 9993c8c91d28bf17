// An eyebot's camera sees beacon and prey where they are.
#include "../checks.hpp"

namespace swarmanoid::conformance {
namespace {

const ChecksRegistration eyebot_camera_checks(
    {EyebotCamera::kType, [](Bench& bench) -> std::vector<Check> { return {camera(bench, EyebotCamera::kType)}; },
     nullptr, nullptr, [](const Bench& bench) -> const ColorBlobs* { return bench.sensor<EyebotCamera>(); }});

}  // namespace
}  // namespace swarmanoid::conformance
