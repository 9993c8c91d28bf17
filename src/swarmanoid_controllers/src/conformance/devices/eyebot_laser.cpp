// The spot moves in the direction of `pan`, farther with more tilt, and disappears when the laser is off.
#include <cmath>
#include <memory>

#include "../checks.hpp"
#include "../pointing.hpp"

namespace swarmanoid::conformance {
namespace {

/// Checks that the spot moves into the direction `pan`, farther with more tilt.
Check laser(Bench& bench) {
  Check check{EyebotLaser::kType, {EyebotLaser::kType, EyebotCamera::kType}, "", {EyebotCamera::kType}, {}};
  check.follows = {"yaw_left"};  // the camera detects faulty motion of the robot first
  const Place below = place();
  const auto way = std::make_shared<double>(0.0);
  check.stages.push_back(
      settle(bench, [&bench] { bench.expectTrue("while it is off there is no red spot", !bench.see(colors::kRed)); }));
  check.stages.push_back(point(bench, 0.0, 0.0, [&bench, below] {
    constexpr double kMount = 0.1;  // m, maximum offset from the robot's centre
    *below = bench.find(colors::kRed, "the spot");
    bench.expectNear("straight down, the spot's distance", below->norm(), 0.0, kMount, "m");
  }));
  for (const double pan : {0.0, M_PI / 2.0, -M_PI / 2.0}) {
    check.stages.push_back(point(bench, pan, kTilt, [&bench, below, pan, way] {
      const Eigen::Vector2d spot = bench.find(colors::kRed, "the spot") - *below;
      bench.expectAngle("direction of the tilted spot, pan " + withUnit(pan, "rad"), bearingOf(spot), pan, 0.15);
      *way = spot.norm();
      if (const double height = bench.surroundings().laser_height; height > 0.0) {
        bench.expectAbout("the tilted spot's way", *way, height * std::tan(kTilt), 0.05, "m");
      }
    }));
  }
  check.stages.push_back(point(bench, 0.0, 0.5 * kTilt, [&bench, below, way] {
    const double half = (bench.find(colors::kRed, "the spot") - *below).norm();
    const double expected = *way * std::tan(0.5 * kTilt) / std::tan(kTilt);
    bench.expectAbout("with half the tilt the spot's way", half, expected, 0.03, "m");
  }));
  check.stages.push_back(settle(bench, nullptr));
  check.stages.back().begin = [&bench] { bench.actuator<EyebotLaser>()->on = false; };
  check.stages.push_back(
      settle(bench, [&bench] { bench.expectTrue("switched off, the spot is gone", !bench.see(colors::kRed)); }));
  check.tidy_up = [&bench] { bench.actuator<EyebotLaser>()->on = false; };
  return check;
}

std::vector<Check> laserChecks(Bench& bench) { return {laser(bench)}; }

const ChecksRegistration laser_checks({EyebotLaser::kType, laserChecks});

}  // namespace
}  // namespace swarmanoid::conformance
