// Flown up and down, the altimeter, the barometer and the distance sensor below say how far.
#include "swarmanoid_interface/devices/eyebot_altitude.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/eyebot_distance.hpp"
#include "swarmanoid_interface/devices/eyebot_pressure.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr std::array<double, 2> kUpFirst{0.2, -0.2};
constexpr std::array<double, 2> kDownFirst{-0.2, 0.2};

/// Flies up and down. @param speeds of the one and of the other [m/s] @param height how high the robot is, by the
/// sensor, from where it does not matter [m]
template <class Device>
Check upAndDown(Bench& bench, const std::array<double, 2>& speeds, double (*height)(const Device&)) {
  Check check{Device::kType, {Device::kType, EyebotVelocity::kType}, needsRoomAbove(bench), {}, {}};
  const auto took = std::make_shared<double>(0.0);
  const auto before = std::make_shared<double>(0.0);
  for (const double speed : speeds) {
    constexpr double kTime = 1.5;  // s
    check.stages.push_back({"flying", kTime, [&bench, before, height] { *before = height(*bench.sensor<Device>()); },
                            [&bench, speed] {
                              bench.actuator<EyebotVelocity>()->linear = {0.0, 0.0, speed};
                            },
                            nullptr, [took](double seconds) { *took = seconds; }});
    check.stages.push_back(settle(bench, [&bench, before, took, height, speed] {
      bench.expectAbout(speed > 0.0 ? "flown up, it is higher by" : "flown down, it is higher by",
                        height(*bench.sensor<Device>()) - *before, speed * *took, kLeastFlownWay, "m");
    }));
  }
  return check;
}

std::vector<Check> altitudeChecks(Bench& bench) {
  return {upAndDown<EyebotAltitude>(bench, kUpFirst, [](const EyebotAltitude& altitude) {
    return std::max(0.0, static_cast<double>(altitude.distance));  // on the ground it is too close: -infinity
  })};
}

std::vector<Check> pressureChecks(Bench& bench) {
  return {upAndDown<EyebotPressure>(bench, kUpFirst, [](const EyebotPressure& pressure) {
    return pressure.difference / EyebotPressure::differenceAt(1.0);  // nearly the same for each metre
  })};
}

/// Its sensors reach less far than the altimeter: it stays below the height at which it starts.
std::vector<Check> downwardsChecks(Bench& bench) {
  if (!bench.isListed(EyebotDistance::kType)) {
    return {};
  }
  return {upAndDown<EyebotDistance>(bench, kDownFirst,
                                    [](const EyebotDistance& distance) { return static_cast<double>(distance.down); })};
}

const ChecksRegistration downwards_checks({EyebotDistance::kType, downwardsChecks});
const ChecksRegistration altitude_checks({EyebotAltitude::kType, altitudeChecks});
const ChecksRegistration pressure_checks({EyebotPressure::kType, pressureChecks});

}  // namespace
}  // namespace swarmanoid::conformance
