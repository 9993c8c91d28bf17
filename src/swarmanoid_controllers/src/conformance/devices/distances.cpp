// Any robot with distance sensors that face right measures the wall there.
#include <cmath>

#include "../wall_on_the_right.hpp"
#include "swarmanoid_interface/devices/distance.hpp"

namespace swarmanoid::conformance {
namespace {

std::vector<Check> distanceChecks(Bench& bench) {
  Check check{Distance::kType, {Distance::kType}, needsWall(bench), {}, {}};
  check.is_at_start = true;
  check.stages.push_back(settle(bench, [&bench] {
    constexpr double kLevel = 0.1;  // rad
    WallOnTheRight wall(bench, "sensor");
    for (const DistanceReading& reading : bench.sensor<Distance>()->sensors) {
      if (std::abs(static_cast<double>(reading.elevation)) < kLevel) {
        wall.look(reading.angle, reading.distance);
      } else {
        wall.skip();
      }
    }
    wall.end();
  }));
  return {check};
}

const ChecksRegistration distance_checks({Distance::kType, distanceChecks});

}  // namespace
}  // namespace swarmanoid::conformance
