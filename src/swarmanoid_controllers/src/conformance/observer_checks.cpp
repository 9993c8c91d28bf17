// The checks of the observer: whether the LEDs of another robot's ring are in the right order and direction.
#include <cmath>
#include <limits>

#include "checks.hpp"

namespace swarmanoid::conformance {
namespace {

void judge(Bench& bench) {
  const Surroundings& place = bench.surroundings();
  const Eigen::Vector2d ahead = bench.find(colors::kRed, "LED 0");
  const Eigen::Vector2d left = bench.find(colors::kBlue, "the LED a quarter of the ring on");
  const Eigen::Vector2d behind = bench.find(colors::kGreen, "the LED half of the ring on");
  if (!bench.failure().empty()) {
    return;
  }
  constexpr double kLength = 0.03;    // m
  constexpr double kDirection = 0.3;  // rad
  const Eigen::Vector2d middle = 0.5 * (ahead + behind);
  const Eigen::Vector2d heading = ahead - behind;
  bench.expectNear("from the red LED to the green one", heading.norm(), 2.0 * place.observed_radius, kLength, "m");
  bench.expectAngle("where the robot has its blue LED", bearingOf(left - middle) - bearingOf(heading), M_PI / 2.0,
                    kDirection);
  bench.expectAngle("where the robot has the observer", bearingOf(-middle) - bearingOf(heading), place.observer_bearing,
                    kDirection);
}

}  // namespace

std::vector<Check> observerChecks(Bench& bench) {
  constexpr double kSightPatience = 10.0;  // s
  Check check{"leds_of_the_other", {bench.cameraDevice()}, "", {}, {}};
  if (bench.cameraDevice().empty()) {
    check.devices.clear();
    check.obstacle = "no camera is listed";
  } else if (bench.surroundings().observed_leds == 0) {
    check.obstacle = "nobody is observed (observed_leds is 0)";
  }
  check.stages.push_back(
      {"seeing a red, a blue and a green LED", kSightPatience, nullptr, nullptr,
       [&bench] { return bench.see(colors::kRed) && bench.see(colors::kBlue) && bench.see(colors::kGreen); }, nullptr});
  check.stages.push_back(settle(bench, [&bench] { judge(bench); }));
  return {check};
}

}  // namespace swarmanoid::conformance
