#include "checks.hpp"

#include <algorithm>
#include <stdexcept>

#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid::conformance {

namespace {

std::vector<DeviceChecks>& registered() {
  static std::vector<DeviceChecks> checks;
  return checks;
}

/// Checks of devices that only this type of robot has are reported as unchecked if its configuration does not list
/// them.
bool concerns(const Bench& bench, const std::string& device) {
  const DeviceType* type = findDeviceType(device);
  return bench.isListed(device) || (type != nullptr && type->robot == bench.robotType());
}

}  // namespace

ChecksRegistration::ChecksRegistration(DeviceChecks checks) {
  std::vector<DeviceChecks>& all = registered();
  const auto place =
      std::find_if(all.begin(), all.end(), [&](const DeviceChecks& other) { return other.device > checks.device; });
  all.insert(place, std::move(checks));
}

const std::vector<DeviceChecks>& deviceChecks() { return registered(); }

std::vector<Check> checksFor(Bench& bench) {
  if (bench.isObserver()) {
    return observerChecks(bench);
  }
  std::vector<Check> checks;
  for (const DeviceChecks& device : deviceChecks()) {
    if (concerns(bench, device.device)) {
      for (Check& check : device.make(bench)) {
        checks.push_back(std::move(check));
      }
    }
  }
  return inOrder(std::move(checks));
}

std::vector<Check> inOrder(std::vector<Check> checks) {
  const auto moving =
      std::stable_partition(checks.begin(), checks.end(), [](const Check& check) { return check.is_only_shown; });
  std::stable_partition(moving, checks.end(), [](const Check& check) { return check.is_at_start; });
  std::vector<Check> ordered;
  while (!checks.empty()) {
    const auto next = std::find_if(checks.begin(), checks.end(), [&](const Check& check) {
      return std::none_of(checks.begin(), checks.end(), [&](const Check& other) {
        return contains(check.after, other.name) || contains(check.follows, other.name) ||
               contains(check.trusts, other.name);
      });
    });
    if (next == checks.end()) {
      throw std::logic_error("check " + checks.front().name + " waits for one that waits for it");
    }
    ordered.push_back(std::move(*next));
    checks.erase(next);
  }
  return ordered;
}

std::function<void()> rememberPlace(Bench& bench, Color color, const std::string& name, const Place& before) {
  return [&bench, color, name, before] { *before = bench.find(color, name); };
}

std::string needsPartner(const Bench& bench) {
  return bench.surroundings().partner.empty() ? "nobody answers here (partner is not given)" : "";
}

std::string needsBeacon(const Bench& bench) {
  return bench.surroundings().beacon_distance > 0.0 ? "" : "there is no beacon (beacon_distance is 0)";
}

std::string needsPrey(const Bench& bench) {
  return bench.surroundings().prey_distance > 0.0 ? "" : "there is no prey (prey_distance is 0)";
}

std::string needsWall(const Bench& bench) {
  return bench.surroundings().wall_distance > 0.0 ? "" : "there is no wall (wall_distance is 0)";
}

std::string needsBoard(const Bench& bench) {
  return bench.surroundings().has_board ? "" : "there is no board before the left hand (board is false)";
}

std::string needsCeiling(const Bench& bench) {
  return bench.surroundings().has_ceiling ? "" : "there is no ferromagnetic ceiling (ceiling is false)";
}

std::string needsRoomAbove(const Bench& bench) {
  return bench.surroundings().is_free_upwards ? "" : "the robot cannot move up and down here (upwards is false)";
}

Stage settle(Bench& bench, std::function<void()> judge) {
  return {"standing still",
          bench.settlingTime(),
          nullptr,
          [&bench] { bench.rest(); },
          nullptr,
          [judge = std::move(judge)](double) {
            if (judge) {
              judge();
            }
          }};
}

Check camera(Bench& bench, const std::string& device) {
  Check check{device, {device}, needsBeacon(bench), {}, {}};
  check.stages.push_back(settle(bench, [&bench] {
    const Surroundings& place = bench.surroundings();
    constexpr double kDistance = 0.05;  // m, accuracy with which objects are placed
    constexpr double kBearing = 0.15;   // rad, the same for directions
    const Eigen::Vector2d beacon = bench.find(place.beacon_color, "the beacon ahead");
    bench.expectAbout("distance of the beacon", beacon.norm(), place.beacon_distance, kDistance, "m");
    bench.expectAngle("bearing of the beacon", bearingOf(beacon), 0.0, kBearing);
    bench.expectTrue("the beacon is below the camera's horizon", isBelowHorizon(bench.seen(), place.beacon_color));
    if (place.prey_distance > 0.0) {
      const Eigen::Vector2d prey = bench.find(place.prey_color, "the prey");
      bench.expectAbout("distance of the prey", prey.norm(), place.prey_distance, kDistance, "m");
      bench.expectAngle("bearing of the prey", bearingOf(prey), place.prey_bearing, kBearing);
    }
  }));
  return check;
}

Check shown(Bench& bench, const std::string& device, std::function<void()> light) {
  constexpr double kShown = 3.0;  // s
  Check check{device, {device}, "", {}, {}};
  check.is_only_shown = true;
  check.stages.push_back({"showing", kShown, std::move(light), [&bench] { bench.rest(); }, nullptr, nullptr});
  return check;
}

}  // namespace swarmanoid::conformance
