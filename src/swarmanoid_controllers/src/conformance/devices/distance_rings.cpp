// The distance sensors of a handbot's or an eyebot's ring that face right measure the wall there, each at its own
// angle: this detects a ring that is turned, mirrored or numbered from another start. The other sensors are not judged.
#include <cmath>
#include <limits>
#include <string>

#include "../checks.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_interface/devices/eyebot_distance.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kAside = 1.1;  // rad: sensors that face further away from the wall may miss its end

/// @param off angle from the normal of the wall [rad] @param radius of the ring [m]
/// @return expected reading of a sensor [m]
double expectedWay(double wall, double off, double radius, Range range) {
  return static_cast<double>(Distance::reading(wall / std::cos(off) - radius, range));
}

template <class Ring>
void judgeSensor(Bench& bench, const Ring& ring, std::size_t i, double off) {
  constexpr double kError = 0.02;  // m, which includes an inexact heading of the robot
  const std::string what = "way from sensor " + std::to_string(i) + " to the wall";
  const double wall = bench.surroundings().wall_distance;
  const Range range{static_cast<double>(ring.range_min), static_cast<double>(ring.range_max)};
  const double expected = expectedWay(wall, off, Ring::kRingRadius, range);
  const auto found = static_cast<double>(ring.value(i));
  if (std::isfinite(expected) && expected < range.maximum - kError && expected > range.minimum + kError) {
    bench.expectNear(what, found, expected, kError, "m");
  } else if (!std::isfinite(expected) && wall / std::cos(off) - Ring::kRingRadius > range.maximum + kError) {
    bench.expectTrue(what + " is out of range (inf): " + withUnit(found, "m"), std::isinf(found) && found > 0.0);
  }
}

/// @param name of the check @param count number of sensors around
template <class Ring>
Check ringCheck(Bench& bench, const std::string& name, std::size_t count) {
  Check check{name, {Ring::kType}, needsWall(bench), {}, {}};
  check.is_at_start = true;
  check.stages.push_back(settle(bench, [&bench, count] {
    const Ring& ring = *bench.sensor<Ring>();
    for (std::size_t i = 0; i < count; ++i) {
      const double off = std::abs(wrapAngle(Ring::angle(i) + M_PI / 2.0));
      if (off < kAside) {
        judgeSensor(bench, ring, i, off);
      }
    }
  }));
  return check;
}

std::vector<Check> handbotDistanceChecks(Bench& bench) {
  if (!bench.isListed(HandbotDistance::kType)) {
    return {};
  }
  return {ringCheck<HandbotDistance>(bench, HandbotDistance::kType, HandbotDistance::kCount)};
}

std::vector<Check> eyebotDistanceChecks(Bench& bench) {
  if (!bench.isListed(EyebotDistance::kType) || !needsWall(bench).empty()) {
    return {};
  }
  return {ringCheck<EyebotDistance>(bench, "eyebot_distance_around", EyebotDistance::kAround)};
}

const ChecksRegistration handbot_ring_checks({HandbotDistance::kType, handbotDistanceChecks});
const ChecksRegistration eyebot_ring_checks({EyebotDistance::kType, eyebotDistanceChecks});

}  // namespace
}  // namespace swarmanoid::conformance
