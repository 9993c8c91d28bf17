// The light sensors of any robot detect the lamp at the test place; those that face it read most. A robot with a
// differential drive turns, and detects it on another side.
#include "swarmanoid_interface/devices/light.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>

#include "../checks.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"

namespace swarmanoid::conformance {
namespace {

std::string needsLamp(const Bench& bench) {
  return bench.surroundings().has_lamp ? "" : "nothing shines here (lamp is false)";
}

/// Vector towards the light: the sum of the readings as vectors.
Eigen::Vector2d lightVector(const Light& light) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const LightReading& reading : light.sensors) {
    const double angle = reading.angle;
    sum += static_cast<double>(reading.value) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return sum;
}

double lightBearing(const Bench& bench) { return bearingOf(lightVector(*bench.sensor<Light>())); }

Check feelsLamp(Bench& bench) {
  Check check{Light::kType, {Light::kType}, needsLamp(bench), {}, {}};
  check.stages.push_back(settle(bench, [&bench] {
    constexpr double kDark = 1e-6;
    const Light& light = *bench.sensor<Light>();
    const double bearing = lightBearing(bench);
    double towards = 0.0;  // maximum reading of the sensors that face the light
    double away = 0.0;     // maximum reading of the others
    for (const LightReading& reading : light.sensors) {
      const double off = std::abs(wrapAngle(static_cast<double>(reading.angle) - bearing));
      double& most = off < M_PI / 2.0 ? towards : away;
      most = std::max(most, static_cast<double>(reading.value));
    }
    bench.expectTrue("some sensor feels the lamp", lightVector(light).norm() > kDark);
    bench.expectTrue("sensors that look to where the light comes from feel more (" + withUnit(towards, "") +
                         ") than the others (" + withUnit(away, "") + ")",
                     towards > away);
  }));
  return check;
}

Check turnsBelowLamp(Bench& bench) {
  constexpr double kRate = 0.5;   // rad/s
  constexpr double kTurn = 1.0;   // rad
  constexpr double kError = 0.3;  // rad, allowed error: there may be few sensors
  Check check{"light_turns", {Light::kType, DifferentialDrive::kType}, needsLamp(bench), {Light::kType}, {}};
  check.follows = {DifferentialDrive::kType};  // that check begins at the start pose
  const auto before = std::make_shared<double>(0.0);
  check.stages.push_back(settle(bench, [&bench, before] { *before = lightBearing(bench); }));
  check.stages.push_back({"turning to the left", kTurn / kRate, nullptr,
                          [&bench] { bench.actuator<DifferentialDrive>()->drive(0.0, kRate); }, nullptr, nullptr});
  check.stages.push_back(settle(bench, [&bench, before] {
    bench.expectAngle("bearing of the light after a turn to the left", lightBearing(bench), *before - kTurn, kError);
  }));
  return check;
}

std::vector<Check> lightChecks(Bench& bench) {
  std::vector<Check> checks{feelsLamp(bench)};
  if (bench.isListed(DifferentialDrive::kType)) {
    checks.push_back(turnsBelowLamp(bench));
  }
  return checks;
}

const ChecksRegistration light_checks({Light::kType, lightChecks});

}  // namespace
}  // namespace swarmanoid::conformance
