// First no obstacle is near; then the wall is ahead, to the right, and behind.
#include <algorithm>
#include <cmath>

#include "../checks.hpp"
#include "../driving.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::conformance {
namespace {

std::size_t strongest(const FootbotProximity& ring) {
  return static_cast<std::size_t>(std::max_element(ring.value.begin(), ring.value.end()) - ring.value.begin());
}

void expectStrongest(Bench& bench, std::size_t expected, const std::string& where) {
  const FootbotProximity& ring = *bench.sensor<FootbotProximity>();
  const std::size_t found = strongest(ring);
  constexpr std::size_t kCount = FootbotProximity::kCount;
  const std::size_t off = std::min((found + kCount - expected) % kCount, (expected + kCount - found) % kCount);
  bench.expectTrue("with the wall " + where + " sensor " + std::to_string(expected) +
                       " +- 1 reads most; found sensor " + std::to_string(found) + " with " +
                       withUnit(static_cast<double>(ring.value[found]), ""),
                   off <= 1 && ring.value[found] > 0.05F);
}

/// Drives to the wall on the right, along it, and back to the start.
Check proximity(Bench& bench) {
  Check check{FootbotProximity::kType,
              {FootbotProximity::kType, FootbotWheels::kType, FootbotCamera::kType},
              needsBeacon(bench),
              {FootbotCamera::kType, "wheels_ahead", "wheels_left"},
              {}};
  if (check.obstacle.empty()) {
    check.obstacle = needsWall(bench);
  }
  const Color beacon = bench.surroundings().beacon_color;
  const Place at_wall = place();
  const auto level = [&bench] {
    const FootbotProximity& ring = *bench.sensor<FootbotProximity>();
    return static_cast<double>(ring.value[strongest(ring)]);
  };
  constexpr double kNear = 0.15;
  check.stages.push_back(settle(bench, [&bench, level] {
    bench.expectNear("away from everything the strongest reading", level(), 0.0, kNear / 3.0, "");
  }));
  check.stages.push_back(turnTo(bench, beacon, [] { return M_PI / 2.0; }));
  const double way = bench.surroundings().wall_distance;
  check.stages.push_back({"driving to the wall until something is near", 1.5 * way / kSpeed + bench.settlingTime(),
                          nullptr, [&bench] { bench.actuator<FootbotWheels>()->drive(kSpeed, 0.0); },
                          [level] { return level() > kNear; }, nullptr});
  check.stages.push_back(settle(bench, [&bench, beacon, at_wall] {
    expectStrongest(bench, 0, "ahead");
    *at_wall = bench.find(beacon, "the beacon");
  }));
  check.stages.push_back(turnTo(bench, beacon, [at_wall] { return bearingOf(*at_wall) - M_PI / 2.0; }));
  check.stages.push_back(settle(bench, [&bench] { expectStrongest(bench, 18, "to the right"); }));
  check.stages.push_back(turnTo(bench, beacon, [at_wall] { return bearingOf(*at_wall) - M_PI; }));
  check.stages.push_back(settle(bench, [&bench] { expectStrongest(bench, 12, "behind"); }));
  check.stages.push_back({"driving away from the wall", kDrivingPatience, nullptr,
                          [&bench] { bench.actuator<FootbotWheels>()->drive(kSpeed, 0.0); },
                          [level] { return level() < kNear / 3.0; }, nullptr});
  return check;
}

std::vector<Check> proximityChecks(Bench& bench) { return {proximity(bench)}; }

const ChecksRegistration proximity_checks({FootbotProximity::kType, proximityChecks, besideWall});

}  // namespace
}  // namespace swarmanoid::conformance
