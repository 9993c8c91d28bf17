// Cameras of a robot besides the one used for the tests: they detect beacon and prey in the right directions. Cameras
// with a lens detect the beacon ahead, but not the prey.
#include <cmath>
#include <memory>
#include <string>

#include "../checks.hpp"
#include "../driving.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kPlacingError = 0.15;  // rad, placement error of the objects

void expectBearing(Bench& bench, const ColorBlobs& seen, Color color, const std::string& name, double bearing) {
  const std::optional<double> found = bearingOf(seen, color);
  if (!found) {
    return bench.fail(name + " (" + toString(color) + ") is not in sight");
  }
  bench.expectAngle("bearing of " + name, *found, bearing, kPlacingError);
}

/// After a turn to the left the beacon is further to the right in the picture. The turn is necessary for cameras that
/// face ahead: a mirrored picture looks correct while the beacon is in its middle.
template <class Camera>
Check turnedCamera(Bench& bench, const Drive& drive) {
  constexpr double kRate = 0.25;  // rad/s
  constexpr double kTime = 1.2;   // s: the beacon stays in the picture
  Check check{
      std::string(Camera::kType) + "_turns", {Camera::kType, drive.device}, needsBeacon(bench), {Camera::kType}, {}};
  if (drive.returns) {
    check.trusts = {drive.check};
  }
  check.is_at_start = true;
  const auto took = std::make_shared<double>(0.0);
  for (const double rate : {kRate, -kRate}) {
    check.stages.push_back({"turning", kTime, nullptr, [drive, rate] { drive.command(0.0, rate); }, nullptr,
                            [took](double seconds) { *took = seconds; }});
    check.stages.push_back(settle(bench, [&bench, took, rate] {
      expectBearing(bench, *bench.sensor<Camera>(), bench.surroundings().beacon_color,
                    rate > 0.0 ? "the beacon after a turn to the left" : "the beacon after the turn back",
                    rate > 0.0 ? -rate * *took : 0.0);
    }));
  }
  return check;
}

/// @param sees_around true: omnidirectional, false: ahead only
template <class Camera>
std::vector<Check> furtherCamera(Bench& bench, bool sees_around) {
  if (!bench.isListed(Camera::kType)) {
    return {};
  }
  Check check{Camera::kType, {Camera::kType}, needsBeacon(bench), {}, {}};
  check.is_at_start = true;
  check.stages.push_back(settle(bench, [&bench, sees_around] {
    const Surroundings& place = bench.surroundings();
    const ColorBlobs& seen = *bench.sensor<Camera>();
    expectBearing(bench, seen, place.beacon_color, "the beacon ahead", 0.0);
    if (sees_around) {
      bench.expectTrue("the beacon is below the camera's horizon", isBelowHorizon(seen, place.beacon_color));
    }
    if (place.prey_distance > 0.0 && sees_around) {
      expectBearing(bench, seen, place.prey_color, "the prey", place.prey_bearing);
    }
    constexpr double kAhead = M_PI / 3.0;    // rad: outside the field of view of every lens
    constexpr double kInPicture = M_PI / 8;  // rad: inside the field of view of every lens
    if (place.prey_distance > 0.0 && !sees_around && std::abs(place.prey_bearing) > kAhead) {
      bench.expectTrue("the prey is out of the picture", !bearingOf(seen, place.prey_color));
    }
    if (place.prey_distance > 0.0 && !sees_around && std::abs(place.prey_bearing) < kInPicture) {
      expectBearing(bench, seen, place.prey_color, "the prey", place.prey_bearing);
    }
  }));
  std::vector<Check> checks{check};
  const auto drive = driveOf(bench);
  if (drive && !sees_around) {
    checks.push_back(turnedCamera<Camera>(bench, *drive));
  }
  return checks;
}

const ChecksRegistration front_camera_checks({FootbotFrontCamera::kType, [](Bench& bench) {
                                                return furtherCamera<FootbotFrontCamera>(bench, false);
                                              }});
const ChecksRegistration handbot_camera_checks({HandbotCamera::kType, [](Bench& bench) {
                                                  return furtherCamera<HandbotCamera>(bench, false);
                                                }});
const ChecksRegistration omnidirectional_checks({EyebotOmnidirectionalCamera::kType, [](Bench& bench) {
                                                   return furtherCamera<EyebotOmnidirectionalCamera>(bench, true);
                                                 }});

}  // namespace
}  // namespace swarmanoid::conformance
