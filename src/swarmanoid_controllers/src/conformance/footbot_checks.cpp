// The checks of a footbot, with a beacon ahead, a prey to the left, a wall to the right.
#include <algorithm>
#include <cmath>
#include <memory>

#include "checks.hpp"
#include "swarmanoid_interface/angle.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr const char* kWheels = FootbotWheels::kType;
constexpr const char* kFootbotCamera = FootbotCamera::kType;
constexpr double kSpeed = 0.1;      // m/s
constexpr double kTurnRate = 0.5;   // rad/s
constexpr double kFastest = 0.8;    // rad/s, to turn towards something
constexpr double kDrive = 2.0;      // s, of a straight drive or a turn
constexpr double kPatience = 20.0;  // s, for actions of unknown duration

std::function<void()> remember(Bench& bench, Color color, const Place& before) {
  return [&bench, color, before] { *before = bench.find(color, "what it looks at"); };
}

Stage drive(Bench& bench, double speed, double turn_rate, const std::shared_ptr<double>& took,
            std::function<void()> begin = nullptr) {
  return {"driving",        kDrive,
          std::move(begin), [&bench, speed, turn_rate] { bench.actuator<FootbotWheels>()->drive(speed, turn_rate); },
          nullptr,          [took](double seconds) { *took = seconds; }};
}

/// Turns on the spot until an object has that bearing.
Stage turnTo(Bench& bench, Color color, std::function<double()> bearing) {
  const auto missing = [&bench, color, bearing = std::move(bearing)] {
    const auto seen = bench.see(color);
    return seen ? wrapTurn(bearingOf(*seen) - bearing()) : 0.5;
  };
  constexpr double kClose = 0.03;  // rad
  return {"turning towards something",
          kPatience,
          nullptr,
          [&bench, missing] {
            bench.actuator<FootbotWheels>()->drive(0.0, std::clamp(2.0 * missing(), -kFastest, kFastest));
          },
          [missing] { return std::abs(missing()) < kClose; },
          nullptr};
}

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

Check wheelsAhead(Bench& bench) {
  Check check{"wheels_ahead", {kWheels, kFootbotCamera}, needsBeacon(bench), {kFootbotCamera}, {}};
  const Color beacon = bench.surroundings().beacon_color;
  const auto took = std::make_shared<double>(0.0);
  for (const double speed : {kSpeed, -kSpeed}) {
    const Place before = place();
    check.stages.push_back(drive(bench, speed, 0.0, took, remember(bench, beacon, before)));
    check.stages.push_back(settle(bench, [&bench, beacon, before, took, speed] {
      const Eigen::Vector2d after = bench.find(beacon, "the beacon");
      bench.expectAbout(speed > 0.0 ? "driven ahead, the beacon is nearer by" : "driven back, the beacon is nearer by",
                        before->norm() - after.norm(), speed * *took, kLeastWay, "m");
      bench.expectAngle("its bearing is still", bearingOf(after), bearingOf(*before), kLeastAngle);
    }));
  }
  return check;
}

Check wheelsLeft(Bench& bench) {
  Check check{"wheels_left", {kWheels, kFootbotCamera}, needsBeacon(bench), {kFootbotCamera}, {}};
  const Color beacon = bench.surroundings().beacon_color;
  const auto took = std::make_shared<double>(0.0);
  for (const double rate : {kTurnRate, -kTurnRate}) {
    const Place before = place();
    check.stages.push_back(drive(bench, 0.0, rate, took, remember(bench, beacon, before)));
    check.stages.push_back(settle(bench, [&bench, beacon, before, took, rate] {
      const Eigen::Vector2d after = bench.find(beacon, "the beacon");
      bench.expectAbout(
          rate > 0.0 ? "turned left, the beacon's bearing changed by" : "turned right, the beacon's bearing changed by",
          wrapTurn(bearingOf(after) - bearingOf(*before)), -rate * *took, kLeastAngle, "rad");
    }));
  }
  return check;
}

/// Drives to the wall on the right, along it, and back to the start.
Check proximity(Bench& bench) {
  Check check{FootbotProximity::kType,
              {FootbotProximity::kType, kWheels, kFootbotCamera},
              needsBeacon(bench),
              {kFootbotCamera, "wheels_ahead", "wheels_left"},
              {}};
  if (check.obstacle.empty() && bench.surroundings().wall_distance == 0.0) {
    check.obstacle = "there is no wall (wall_distance is 0)";
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
  check.stages.push_back({"driving away from the wall", kPatience, nullptr,
                          [&bench] { bench.actuator<FootbotWheels>()->drive(kSpeed, 0.0); },
                          [level] { return level() < kNear / 3.0; }, nullptr});
  return check;
}

Check gripperCloses(Bench& bench) {
  const Color prey = bench.surroundings().prey_color;
  Check check{"gripper_closes",
              {FootbotGripper::kType, FootbotGripperState::kType, kWheels, kFootbotCamera},
              needsPrey(bench),
              {kFootbotCamera, "wheels_ahead", "wheels_left"},
              {}};
  check.stages.push_back(settle(bench, [&bench] {
    bench.expectTrue("nothing is held at first", !bench.sensor<FootbotGripperState>()->gripping);
  }));
  check.stages.push_back(turnTo(bench, prey, [] { return 0.0; }));
  check.stages.push_back({"driving to the prey and gripping it", kPatience, nullptr,
                          [&bench, prey] {
                            constexpr double kReach = 0.22;  // m, within which it is slow and the gripper closed
                            const Eigen::Vector2d seen = bench.see(prey).value_or(Eigen::Vector2d::Zero());
                            const bool is_near = seen.norm() < kReach;
                            bench.actuator<FootbotGripper>()->closed = is_near;
                            bench.actuator<FootbotWheels>()->drive(is_near ? 0.3 * kSpeed : kSpeed,
                                                                   std::clamp(bearingOf(seen), -kTurnRate, kTurnRate));
                          },
                          [&bench] { return bench.sensor<FootbotGripperState>()->gripping; }, nullptr});
  check.stages.push_back(settle(bench, [&bench, prey] {
    bench.expectTrue("it still holds the prey", bench.sensor<FootbotGripperState>()->gripping);
    bench.expectAngle("bearing of what is held", bearingOf(bench.find(prey, "the prey")), 0.0, 0.3);
  }));
  check.tidy_up = [&bench] { bench.actuator<FootbotGripper>()->open(); };
  return check;
}

Check turret(Bench& bench) {
  Check check{FootbotTurret::kType, {FootbotTurret::kType, FootbotTurretState::kType}, "", {}, {}};
  const Color prey = bench.surroundings().prey_color;
  for (const double angle : {0.5, -0.4, 0.0}) {
    constexpr double kClose = 0.05;  // rad
    check.stages.push_back({"turning the turret to " + withUnit(angle, "rad"), kPatience / 2.0, nullptr,
                            [&bench, angle] { bench.actuator<FootbotTurret>()->holdAngle(angle); },
                            [&bench, angle] {
                              // with a prey in the gripper the turret may swing for a while
                              const FootbotTurretState& state = *bench.sensor<FootbotTurretState>();
                              return std::abs(state.angle - angle) < kClose && std::abs(state.speed) < kClose;
                            },
                            nullptr});
    check.stages.push_back(settle(bench, [&bench, angle, prey] {
      bench.expectAngle("the turret's angle", bench.sensor<FootbotTurretState>()->angle, angle, kClose);
      const auto* gripper = bench.sensor<FootbotGripperState>();
      const auto held = bench.see(prey);
      if (gripper != nullptr && gripper->gripping && held) {
        bench.expectAngle("bearing of what it holds", bearingOf(*held), angle, 0.3);
      }
    }));
  }
  return check;
}

Check gripperOpens(Bench& bench) {
  const Color prey = bench.surroundings().prey_color;
  const auto took = std::make_shared<double>(0.0);
  const Place before = place();
  Check check{"gripper_opens",
              {FootbotGripper::kType, FootbotGripperState::kType, kWheels, kFootbotCamera},
              needsPrey(bench),
              {"gripper_closes"},
              {}};
  check.stages.push_back({"letting go", 2.0, [&bench] { bench.actuator<FootbotGripper>()->open(); }, nullptr,
                          [&bench] { return !bench.sensor<FootbotGripperState>()->gripping; }, nullptr});
  check.stages.push_back(drive(bench, -kSpeed, 0.0, took, remember(bench, prey, before)));
  check.stages.push_back(settle(bench, [&bench, prey, before, took] {
    bench.expectAbout("driven back, the prey is farther by", bench.find(prey, "the prey").norm() - before->norm(),
                      kSpeed * *took, kLeastWay, "m");
  }));
  return check;
}

}  // namespace

std::vector<Check> footbotChecks(Bench& bench) {
  const auto light = [&bench] {
    FootbotLeds& leds = *bench.actuator<FootbotLeds>();
    leds.setAll(colors::kBlack);
    leds.ring[0] = colors::kRed;
    leds.ring[FootbotLeds::kCount / 4] = colors::kBlue;
    leds.ring[FootbotLeds::kCount / 2] = colors::kGreen;
  };
  return {ledsShown(bench, FootbotLeds::kType, light),
          camera(bench, kFootbotCamera),
          wheelsAhead(bench),
          wheelsLeft(bench),
          proximity(bench),
          gripperCloses(bench),
          turret(bench),
          gripperOpens(bench)};
}

}  // namespace swarmanoid::conformance
