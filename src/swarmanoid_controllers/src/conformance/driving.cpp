#include "driving.hpp"

#include <algorithm>
#include <cmath>

#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid::conformance {

Stage drive(Bench& bench, double speed, double turn_rate, const std::shared_ptr<double>& took,
            std::function<void()> begin) {
  constexpr double kTime = 2.0;  // s, of a straight drive or a turn
  return {"driving",        kTime,
          std::move(begin), [&bench, speed, turn_rate] { bench.actuator<FootbotWheels>()->drive(speed, turn_rate); },
          nullptr,          [took](double seconds) { *took = seconds; }};
}

Stage turnTo(Bench& bench, Color color, std::function<double()> bearing) {
  const auto missing = [&bench, color, bearing = std::move(bearing)] {
    const auto seen = bench.see(color);
    return seen ? wrapTurn(bearingOf(*seen) - bearing()) : 0.5;
  };
  constexpr double kClose = 0.03;          // rad
  static constexpr double kFastest = 0.8;  // rad/s
  return {"turning towards something",
          kDrivingPatience,
          nullptr,
          [&bench, missing] {
            bench.actuator<FootbotWheels>()->drive(0.0, std::clamp(2.0 * missing(), -kFastest, kFastest));
          },
          [missing] { return std::abs(missing()) < kClose; },
          nullptr};
}

std::optional<Drive> driveOf(const Bench& bench) {
  if (auto* wheels = bench.actuator<FootbotWheels>()) {
    return Drive{FootbotWheels::kType, "wheels_left", true,
                 [wheels](double speed, double turn_rate) { wheels->drive(speed, turn_rate); }};
  }
  if (auto* drive = bench.actuator<DifferentialDrive>()) {
    return Drive{DifferentialDrive::kType, DifferentialDrive::kType, false,
                 [drive](double speed, double turn_rate) { drive->drive(speed, turn_rate); }};
  }
  return std::nullopt;
}

std::optional<Drive> turningDriveOf(const Bench& bench) {
  if (auto* velocity = bench.actuator<EyebotVelocity>()) {
    return Drive{EyebotVelocity::kType, "yaw_left", true, [velocity](double speed, double turn_rate) {
                   velocity->linear = {speed, 0.0, 0.0};
                   velocity->yaw_rate = turn_rate;
                 }};
  }
  return driveOf(bench);
}

}  // namespace swarmanoid::conformance
