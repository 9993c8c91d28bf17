// Cameras that a robot has beside the one by which it is tested: they see beacon and prey in their directions. Those
// with a lens see the beacon ahead, and not the prey.
#include <cmath>

#include "../checks.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kPlacingError = 0.15;  // rad, of how objects are placed

void expectBearing(Bench& bench, const ColorBlobs& seen, Color color, const std::string& name, double bearing) {
  const std::optional<double> found = bearingOf(seen, color);
  if (!found) {
    return bench.fail(name + " (" + toString(color) + ") is not in sight");
  }
  bench.expectAngle("bearing of " + name, *found, bearing, kPlacingError);
}

/// @param sees_around or ahead only
template <class Camera>
std::vector<Check> furtherCamera(Bench& bench, bool sees_around) {
  if (!bench.isListed(Camera::kType)) {
    return {};
  }
  Check check{Camera::kType, {Camera::kType}, needsBeacon(bench), {}, {}};
  check.stages.push_back(settle(bench, [&bench, sees_around] {
    const Surroundings& place = bench.surroundings();
    const ColorBlobs& seen = *bench.sensor<Camera>();
    expectBearing(bench, seen, place.beacon_color, "the beacon ahead", 0.0);
    if (place.prey_distance > 0.0 && sees_around) {
      expectBearing(bench, seen, place.prey_color, "the prey", place.prey_bearing);
    }
    constexpr double kAhead = M_PI / 3.0;  // rad: no lens shows what is further to the side
    if (place.prey_distance > 0.0 && !sees_around && std::abs(place.prey_bearing) > kAhead) {
      bench.expectTrue("the prey is out of the picture", !bearingOf(seen, place.prey_color));
    }
  }));
  return {check};
}

const ChecksRegistration front_camera_checks({FootbotFrontCamera::kType, [](Bench& bench) {
                                                return furtherCamera<FootbotFrontCamera>(bench, false);
                                              }});
const ChecksRegistration omnidirectional_checks({EyebotOmnidirectionalCamera::kType, [](Bench& bench) {
                                                   return furtherCamera<EyebotOmnidirectionalCamera>(bench, true);
                                                 }});

}  // namespace
}  // namespace swarmanoid::conformance
