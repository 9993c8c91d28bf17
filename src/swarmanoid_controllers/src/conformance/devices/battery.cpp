// Any robot that has a battery uses it up, the more so when it drives, and knows what is left.
#include "swarmanoid_interface/devices/battery.hpp"

#include <cmath>
#include <memory>

#include "../checks.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kDrivingTime = 2.0;  // s

/// The charge never rises while the robot drives to and fro, or stands; at the end there is less.
Stage watch(Bench& bench, double speed, const std::shared_ptr<float>& before, const std::shared_ptr<float>& last) {
  return {speed > 0.0   ? "driving ahead"
          : speed < 0.0 ? "driving back"
                        : "standing",
          kDrivingTime,
          [&bench, before, last] { *before = *last = bench.sensor<Battery>()->charge; },
          [&bench, speed, last] {
            if (auto* drive = bench.actuator<DifferentialDrive>()) {
              drive->drive(speed, 0.0);
            }
            const float now = bench.sensor<Battery>()->charge;
            if (now > *last) {
              bench.fail("the charge rises while nothing charges the robot");
            }
            *last = now;
          },
          nullptr,
          [&bench, before](double) {
            bench.expectTrue("some of the charge is used", bench.sensor<Battery>()->charge < *before);
          }};
}

std::vector<Check> batteryChecks(Bench& bench) {
  const auto before = std::make_shared<float>(0.0F);
  const auto last = std::make_shared<float>(0.0F);
  Check plausible{"battery_plausible", {Battery::kType}, "", {}, {}};
  plausible.stages.push_back(settle(bench, [&bench] {
    const Battery& battery = *bench.sensor<Battery>();
    bench.expectTrue("it has a capacity", battery.capacity > 0.0F && std::isfinite(battery.capacity));
    bench.expectTrue("it holds no more than that, and not nothing",
                     battery.charge > 0.0F && battery.charge <= battery.capacity);
    bench.expectTrue("it has a voltage", battery.voltage > 0.0F);
  }));
  Check drains{"battery_drains", {Battery::kType}, "", {plausible.name}, {}};
  if (bench.isListed(DifferentialDrive::kType)) {
    constexpr double kSlow = 0.1;  // m/s
    drains.devices.emplace_back(DifferentialDrive::kType);
    drains.follows = {DifferentialDrive::kType};  // which begins where the robot was put
    drains.stages = {watch(bench, kSlow, before, last), watch(bench, -kSlow, before, last)};
  } else {
    drains.stages = {watch(bench, 0.0, before, last)};
  }
  return {plausible, drains};
}

const ChecksRegistration battery_checks({Battery::kType, batteryChecks});

}  // namespace
}  // namespace swarmanoid::conformance
