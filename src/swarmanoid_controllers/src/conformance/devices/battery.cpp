// Any robot with a battery consumes its charge, measures the rest, and reports charging and exchanges.
#include "swarmanoid_interface/devices/battery.hpp"

#include <cmath>
#include <memory>

#include "../checks.hpp"
#include "../driving.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kWatchingTime = 2.0;  // s
constexpr double kLeastChange = 2.0;   // J, allowed error of a charge: a charger may transfer it in portions

/// Readings of the gauge while no charger acts on the robot.
struct Draining {
  float before = 0.0F;  ///< initial charge [J]
  float last = 0.0F;    ///< charge in the last tick [J]
  double power = 0.0;   ///< sum over the ticks [W]
  double ticks = 0.0;
};

/// The charge never rises while the robot drives to and fro, or stands; its decrease matches the power.
Stage watch(Bench& bench, const Drive& drive, double speed) {
  const auto seen = std::make_shared<Draining>();
  return {speed > 0.0   ? "driving ahead"
          : speed < 0.0 ? "driving back"
                        : "standing",
          kWatchingTime,
          [&bench, seen] { seen->before = seen->last = bench.sensor<Battery>()->charge; },
          [&bench, drive, speed, seen] {
            if (drive.command) {
              drive.command(speed, 0.0);
            }
            const Battery& battery = *bench.sensor<Battery>();
            if (battery.charge > seen->last) {
              bench.fail("the charge rises while nothing charges the robot");
            }
            seen->last = battery.charge;
            seen->power += static_cast<double>(battery.power);
            seen->ticks += 1.0;
          },
          nullptr,
          [&bench, seen](double took) {
            const Battery& battery = *bench.sensor<Battery>();
            bench.expectTrue("some of the charge is used", battery.charge < seen->before);
            if (!bench.surroundings().has_exchanger) {  // after an exchange the battery also fills the super-capacitor
              bench.expectAbout("charge that is used", static_cast<double>(seen->before - battery.charge),
                                seen->power / seen->ticks * took, kLeastChange, "J");
            }
            bench.expectTrue("the robot draws power, and nothing charges it",
                             battery.power > 0.0F && !battery.is_charging);
          }};
}

/// Drives out of the reach of the charger.
Stage leave(Bench& bench, const Drive& drive) {
  constexpr double kLeavingTime = 6.0;  // s
  Stage stage = settle(bench, nullptr);
  stage.what = "driving away from what charges it";
  stage.seconds = kLeavingTime;
  stage.act = [drive] { drive.command(kSpeed, 0.0); };
  return stage;
}

/// At a charger the charge rises, by an amount that matches the power.
Check charges(Bench& bench) {
  constexpr double kTime = 3.0;  // s
  Check check{"battery_charges", {Battery::kType}, "", {"battery_plausible"}, {}};
  check.is_at_start = true;
  const auto before = std::make_shared<float>(0.0F);
  check.stages.push_back(settle(bench, nullptr));
  check.stages.push_back({"standing where something charges it", kTime,
                          [&bench, before] { *before = bench.sensor<Battery>()->charge; }, nullptr, nullptr,
                          [&bench, before](double took) {
                            const Battery& battery = *bench.sensor<Battery>();
                            bench.expectTrue("something charges it", battery.is_charging);
                            bench.expectTrue("it is not full", battery.fraction() < 1.0F);
                            bench.expectTrue(
                                "more comes in than is drawn: " + withUnit(static_cast<double>(battery.power), "W"),
                                battery.power < 0.0F);
                            bench.expectAbout("the charge has risen by", static_cast<double>(battery.charge - *before),
                                              -static_cast<double>(battery.power) * took, kLeastChange, "J");
                          }});
  return check;
}

/// During an exchange of the battery the robot runs on its super-capacitor, and afterwards has more charge than before.
Check isExchanged(Bench& bench) {
  constexpr double kPatience = 60.0;  // s
  Check check{"battery_exchanged", {Battery::kType}, "", {}, {}};
  check.is_at_start = true;
  const auto before = std::make_shared<float>(0.0F);
  check.always = [&bench, before, is_known = false]() mutable {
    if (!is_known && !bench.sensor<Battery>()->on_capacitor) {
      *before = bench.sensor<Battery>()->charge;
    }
    is_known = is_known || bench.sensor<Battery>()->on_capacitor;
  };
  check.stages.push_back({"losing the old battery", kPatience, nullptr, nullptr,
                          [&bench] { return bench.sensor<Battery>()->on_capacitor; },
                          [&bench](double) {
                            bench.expectTrue("while the battery is out, it holds nothing",
                                             bench.sensor<Battery>()->charge <= 0.0F);
                          }});
  check.stages.push_back({"getting the new battery", kPatience, nullptr, nullptr,
                          [&bench] { return !bench.sensor<Battery>()->on_capacitor; },
                          [&bench, before](double) {
                            bench.expectTrue("the new battery holds more than the old one",
                                             bench.sensor<Battery>()->charge > *before);
                          }});
  return check;
}

std::vector<Check> batteryChecks(Bench& bench) {
  Check plausible{"battery_plausible", {Battery::kType}, "", {}, {}};
  plausible.stages.push_back(settle(bench, [&bench] {
    const Battery& battery = *bench.sensor<Battery>();
    bench.expectTrue("it has a capacity", battery.capacity > 0.0F && std::isfinite(battery.capacity));
    bench.expectTrue("it holds no more than that, and not nothing",
                     battery.charge > 0.0F && battery.charge <= battery.capacity);
    bench.expectTrue("it has a voltage", battery.voltage > 0.0F);
  }));
  Check drains{"battery_drains", {Battery::kType}, "", {plausible.name}, {}};
  const auto drive = driveOf(bench);
  const bool is_charged = bench.surroundings().has_charger;
  if (drive) {
    drains.devices.push_back(drive->device);
    drains.follows = {drive->check};  // that check begins at the start pose
    if (is_charged) {
      drains.stages.push_back(leave(bench, *drive));
    }
    drains.stages.push_back(watch(bench, *drive, kSpeed));
    drains.stages.push_back(watch(bench, *drive, -kSpeed));
  } else {
    drains.obstacle = is_charged ? "something charges it here (charger is true), and it cannot drive away" : "";
    drains.stages = {watch(bench, {}, 0.0)};
  }
  std::vector<Check> checks{plausible, drains};
  if (is_charged) {
    checks.push_back(charges(bench));
  }
  if (bench.surroundings().has_exchanger) {
    checks.push_back(isExchanged(bench));
  }
  return checks;
}

const ChecksRegistration battery_checks({Battery::kType, batteryChecks});

}  // namespace
}  // namespace swarmanoid::conformance
