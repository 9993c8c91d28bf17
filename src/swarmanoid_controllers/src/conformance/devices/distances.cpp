// Any robot with distance sensors that look to the right measures the wall there. Where its sensors sit is not known
// here, only that they are on the robot.
#include <cmath>
#include <string>

#include "../checks.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/distance.hpp"

namespace swarmanoid::conformance {
namespace {

/// Whether it looks level and at most that far from the right.
bool looksRight(const DistanceReading& reading) {
  constexpr double kOff = 0.5;    // rad
  constexpr double kLevel = 0.1;  // rad
  return std::abs(wrapAngle(static_cast<double>(reading.angle) + M_PI / 2.0)) < kOff &&
         std::abs(static_cast<double>(reading.elevation)) < kLevel;
}

std::vector<Check> distanceChecks(Bench& bench) {
  const double wall = bench.surroundings().wall_distance;
  Check check{Distance::kType, {Distance::kType}, needsWall(bench), {}, {}};
  check.is_at_start = true;
  check.stages.push_back(settle(bench, [&bench, wall] {
    const Distance& distances = *bench.sensor<Distance>();
    std::size_t looking = 0;
    for (std::size_t i = 0; i < distances.sensors.size(); ++i) {
      const DistanceReading& reading = distances.sensors[i];
      if (looksRight(reading)) {
        ++looking;
        const double ahead =
            static_cast<double>(reading.distance) * std::cos(static_cast<double>(reading.angle) + M_PI / 2.0);
        bench.expectNear("way from sensor " + std::to_string(i) + " to the wall", ahead, 0.65 * wall, 0.35 * wall, "m");
      }
    }
    bench.expectTrue("some sensor looks to the right", looking > 0);
  }));
  return {check};
}

const ChecksRegistration distance_checks({Distance::kType, distanceChecks});

}  // namespace
}  // namespace swarmanoid::conformance
