#include "checks.hpp"

namespace swarmanoid::conformance {

std::vector<Check> checksFor(Bench& bench) {
  if (bench.isObserver()) {
    return observerChecks(bench);
  }
  const std::string& type = bench.robot().type();
  if (type == "footbot") {
    return footbotChecks(bench);
  }
  if (type == "eyebot") {
    return eyebotChecks(bench);
  }
  return type == "handbot" ? handbotChecks(bench) : std::vector<Check>{};
}

std::string needsBeacon(const Bench& bench) {
  return bench.surroundings().beacon_distance > 0.0 ? "" : "there is no beacon (beacon_distance is 0)";
}

std::string needsPrey(const Bench& bench) {
  return bench.surroundings().prey_distance > 0.0 ? "" : "there is no prey (prey_distance is 0)";
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
    constexpr double kBearing = 0.15;   // rad, likewise
    const Eigen::Vector2d beacon = bench.find(place.beacon_color, "the beacon ahead");
    bench.expectAbout("distance of the beacon", beacon.norm(), place.beacon_distance, kDistance, "m");
    bench.expectAngle("bearing of the beacon", bearingOf(beacon), 0.0, kBearing);
    if (place.prey_distance > 0.0) {
      const Eigen::Vector2d prey = bench.find(place.prey_color, "the prey");
      bench.expectAbout("distance of the prey", prey.norm(), place.prey_distance, kDistance, "m");
      bench.expectAngle("bearing of the prey", bearingOf(prey), place.prey_bearing, kBearing);
    }
  }));
  return check;
}

Check ledsShown(Bench& bench, const std::string& device, std::function<void()> light) {
  constexpr double kShown = 3.0;  // s
  Check check{device, {device}, "", {}, {}};
  check.is_only_shown = true;
  check.stages.push_back({"showing", kShown, std::move(light), [&bench] { bench.rest(); }, nullptr, nullptr});
  return check;
}

}  // namespace swarmanoid::conformance
