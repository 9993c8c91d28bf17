// During a flight to a point ahead and to the left, and back, the beacon moves the opposite way in the robot's frame.
#include "swarmanoid_interface/devices/eyebot_position.hpp"

#include "../checks.hpp"

namespace swarmanoid::conformance {
namespace {

std::vector<Check> positionChecks(Bench& bench) {
  Check check{EyebotPosition::kType,
              {EyebotPosition::kType, EyebotCamera::kType},
              needsBeacon(bench),
              {EyebotCamera::kType},
              {}};
  const Color beacon = bench.surroundings().beacon_color;
  const Place start = place();
  const Eigen::Vector3d there(0.25, 0.15, 0.0);
  for (const bool goes_there : {true, false}) {
    const Eigen::Vector3d target = goes_there ? there : Eigen::Vector3d::Zero();
    constexpr double kTime = 5.0;  // s
    Stage stage{"flying to a place",
                kTime,
                nullptr,
                [&bench, target] { bench.actuator<EyebotPosition>()->goTo(target, 0.0); },
                nullptr,
                [&bench, start, beacon, target](double) {
                  const Eigen::Vector2d moved = *start - bench.find(beacon, "the beacon");
                  bench.expectNear("the way along x", moved.x(), target.x(), kLeastFlownWay, "m");
                  bench.expectNear("the way along y", moved.y(), target.y(), kLeastFlownWay, "m");
                }};
    if (goes_there) {
      stage.begin = rememberPlace(bench, beacon, "the beacon", start);
    }
    check.stages.push_back(std::move(stage));
  }
  return {check};
}

void hover(const Bench& bench) { bench.actuator<EyebotPosition>()->hover(); }

const ChecksRegistration position_checks({EyebotPosition::kType, positionChecks, nullptr, hover});

}  // namespace
}  // namespace swarmanoid::conformance
