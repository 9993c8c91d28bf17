// The altimeter, the barometer and the downward and upward distance sensors measure the height differences of a flight
// up and down.
#include "swarmanoid_interface/devices/eyebot_altitude.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/eyebot_distance.hpp"
#include "swarmanoid_interface/devices/eyebot_pressure.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr std::array<double, 2> kUpFirst{0.2, -0.2};
constexpr std::array<double, 2> kDownFirst{-0.2, 0.2};

/// One flight: its duration, and the change in height.
struct Flight {
  double took = 0.0;    // s
  double before = 0.0;  // m
  double rise = 0.0;    // m
};

/// Flies up and down, and judges after the return, so that a failing sensor does not disturb later checks.
/// @param name of the check @param speeds of the two flights [m/s]
/// @param height function that converts a reading to a height above any fixed reference [m]
template <class Device>
Check upAndDown(Bench& bench, const std::string& name, const std::array<double, 2>& speeds,
                double (*height)(const Device&)) {
  Check check{name, {Device::kType, EyebotVelocity::kType}, needsRoomAbove(bench), {}, {}};
  const auto flights = std::make_shared<std::array<Flight, 2>>();
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    constexpr double kTime = 1.5;  // s
    check.stages.push_back({"flying", kTime,
                            [&bench, flights, i, height] { (*flights)[i].before = height(*bench.sensor<Device>()); },
                            [&bench, speed = speeds[i]] {
                              bench.actuator<EyebotVelocity>()->linear = {0.0, 0.0, speed};
                            },
                            nullptr, [flights, i](double seconds) { (*flights)[i].took = seconds; }});
    check.stages.push_back(settle(bench, [&bench, flights, i, height] {
      (*flights)[i].rise = height(*bench.sensor<Device>()) - (*flights)[i].before;
    }));
  }
  check.stages.push_back({"judging", 0.0, nullptr, nullptr, nullptr, [&bench, flights, speeds](double) {
                            for (std::size_t i = 0; i < speeds.size(); ++i) {
                              bench.expectAbout(
                                  speeds[i] > 0.0 ? "flown up, it is higher by" : "flown down, it is higher by",
                                  (*flights)[i].rise, speeds[i] * (*flights)[i].took, kLeastFlownWay, "m");
                            }
                          }});
  return check;
}

std::vector<Check> altitudeChecks(Bench& bench) {
  return {upAndDown<EyebotAltitude>(bench, EyebotAltitude::kType, kUpFirst, [](const EyebotAltitude& altitude) {
    return std::max(0.0, static_cast<double>(altitude.distance));  // on the ground: -infinity, below the range
  })};
}

std::vector<Check> pressureChecks(Bench& bench) {
  return {upAndDown<EyebotPressure>(bench, EyebotPressure::kType, kUpFirst, [](const EyebotPressure& pressure) {
    return pressure.difference / EyebotPressure::differenceAt(1.0);  // the change per metre is nearly constant
  })};
}

/// The sensors have a shorter range than the altimeter, so the robot stays below its start height.
std::vector<Check> upAndDownwardsChecks(Bench& bench) {
  using Ring = EyebotDistance;
  if (!bench.isListed(Ring::kType)) {
    return {};
  }
  std::vector<Check> checks{
      upAndDown<Ring>(bench, Ring::kType, kDownFirst, [](const Ring& ring) { return static_cast<double>(ring.down); })};
  if (bench.surroundings().has_ceiling) {
    checks.push_back(upAndDown<Ring>(bench, "eyebot_distance_up", kUpFirst,
                                     [](const Ring& ring) { return -static_cast<double>(ring.up); }));
  }
  return checks;
}

const ChecksRegistration downwards_checks({EyebotDistance::kType, upAndDownwardsChecks});
const ChecksRegistration altitude_checks({EyebotAltitude::kType, altitudeChecks});
const ChecksRegistration pressure_checks({EyebotPressure::kType, pressureChecks});

}  // namespace
}  // namespace swarmanoid::conformance
