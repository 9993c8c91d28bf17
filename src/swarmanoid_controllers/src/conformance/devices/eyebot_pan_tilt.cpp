// The camera sees the prey when panned and tilted towards it, but not when panned to the other side.
#include "swarmanoid_interface/devices/eyebot_pan_tilt.hpp"

#include <cmath>

#include "../checks.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kSteepest = 1.25;  // rad: at a steeper tilt every pan angle would show the prey

/// Depression angle of the prey, seen from about the laser pointer [rad].
double angleDownToPrey(const Bench& bench) {
  return std::atan2(bench.surroundings().laser_height, bench.surroundings().prey_distance);
}

std::string panTiltObstacle(const Bench& bench) {
  if (std::string no_prey = needsPrey(bench); !no_prey.empty()) {
    return no_prey;
  }
  if (bench.surroundings().laser_height == 0.0) {
    return "the height of the robot is not known (laser_height is 0)";
  }
  return angleDownToPrey(bench) > kSteepest ? "the prey lies too near below the robot" : "";
}

/// Turns the camera, and waits until it has turned.
Stage look(Bench& bench, double pan, const std::function<void(bool is_seen)>& judge) {
  constexpr double kTurning = 3.0;  // s
  return {"turning the camera",
          kTurning,
          [&bench, pan] {
            bench.actuator<EyebotPanTilt>()->pan = pan;
            bench.actuator<EyebotPanTilt>()->tilt = -angleDownToPrey(bench);
          },
          nullptr,
          nullptr,
          [&bench, judge](double) {
            judge(bearingOf(*bench.sensor<EyebotPanTiltCamera>(), bench.surroundings().prey_color).has_value());
          }};
}

std::vector<Check> panTiltChecks(Bench& bench) {
  if (!bench.isListed(EyebotPanTilt::kType)) {
    return {};
  }
  const double bearing = bench.surroundings().prey_bearing;
  Check check{EyebotPanTilt::kType, {EyebotPanTilt::kType, EyebotPanTiltCamera::kType}, panTiltObstacle(bench), {}, {}};
  check.stages.push_back(look(bench, bearing, [&bench](bool is_seen) {
    bench.expectTrue("turned towards the prey, the camera sees it", is_seen);
  }));
  check.stages.push_back(look(bench, bearing - std::copysign(M_PI, bearing), [&bench](bool is_seen) {
    bench.expectTrue("turned to the other side, it does not", !is_seen);
  }));
  return {check};
}

const ChecksRegistration pan_tilt_checks({EyebotPanTilt::kType, panTiltChecks});

}  // namespace
}  // namespace swarmanoid::conformance
