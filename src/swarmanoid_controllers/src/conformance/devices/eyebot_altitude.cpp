// Flown up and down, the altimeter and the barometer say how far.
#include "swarmanoid_interface/devices/eyebot_altitude.hpp"

#include <algorithm>
#include <memory>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/eyebot_pressure.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"

namespace swarmanoid::conformance {
namespace {

/// Flies up and down. @param height how high the robot is, by the sensor, from where it does not matter [m]
template <class Device>
Check upAndDown(Bench& bench, double (*height)(const Device&)) {
  Check check{Device::kType, {Device::kType, EyebotVelocity::kType}, needsRoomAbove(bench), {}, {}};
  const auto took = std::make_shared<double>(0.0);
  const auto before = std::make_shared<double>(0.0);
  for (const double speed : {0.2, -0.2}) {
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
  return {upAndDown<EyebotAltitude>(bench, [](const EyebotAltitude& altitude) {
    return std::max(0.0, static_cast<double>(altitude.distance));  // on the ground it is too close: -infinity
  })};
}

std::vector<Check> pressureChecks(Bench& bench) {
  return {upAndDown<EyebotPressure>(bench, [](const EyebotPressure& pressure) {
    return pressure.difference / EyebotPressure::differenceAt(1.0);  // nearly the same for each metre
  })};
}

const ChecksRegistration altitude_checks({EyebotAltitude::kType, altitudeChecks});
const ChecksRegistration pressure_checks({EyebotPressure::kType, pressureChecks});

}  // namespace
}  // namespace swarmanoid::conformance
