// The checks of the observer: the order and direction of the LEDs in another robot's ring, or their common colour, and
// the other robot's effects on further devices.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "checks.hpp"

namespace swarmanoid::conformance {
namespace {

constexpr double kSightPatience = 10.0;  // s

/// Last seen positions of the LEDs, which may shine one after the other [m].
struct Seen {
  std::optional<Eigen::Vector2d> ahead;
  std::optional<Eigen::Vector2d> left;
  std::optional<Eigen::Vector2d> behind;

  /// @return whether all were seen
  bool look(const Bench& bench) {
    const auto update = [&bench](Color color, std::optional<Eigen::Vector2d>& place) {
      if (const auto now = bench.see(color)) {
        place = now;
      }
      return place.has_value();
    };
    const bool is_ahead_seen = update(colors::kRed, ahead);
    const bool is_left_seen = update(colors::kBlue, left);
    return update(colors::kGreen, behind) && is_ahead_seen && is_left_seen;
  }
};

void judge(Bench& bench, const Seen& seen) {
  const Surroundings& place = bench.surroundings();
  const Eigen::Vector2d ahead = *seen.ahead;
  const Eigen::Vector2d left = *seen.left;
  const Eigen::Vector2d behind = *seen.behind;
  constexpr double kLength = 0.03;    // m
  constexpr double kDirection = 0.3;  // rad
  const Eigen::Vector2d middle = 0.5 * (ahead + behind);
  const Eigen::Vector2d heading = ahead - behind;
  bench.expectNear("from the red LED to the green one", heading.norm(), 2.0 * place.observed_radius, kLength, "m");
  bench.expectAngle("where the robot has its blue LED", bearingOf(left - middle) - bearingOf(heading), M_PI / 2.0,
                    kDirection);
  bench.expectAngle("where the robot has the observer", bearingOf(-middle) - bearingOf(heading), place.observer_bearing,
                    kDirection);
}

Check ringInThreeColors(Bench& bench) {
  Check check{"leds_of_the_other", {bench.cameraDevice()}, "", {}, {}};
  const auto seen = std::make_shared<Seen>();
  const auto look = [&bench, seen] { return seen->look(bench); };
  check.stages.push_back({"seeing a red, a blue and a green LED", kSightPatience, nullptr, nullptr, look, nullptr});
  check.stages.push_back(settle(bench, [&bench, seen, look] {
    look();
    judge(bench, *seen);
  }));
  return check;
}

/// Checks that at least about half of the ring is visible, that the visible part is as wide as the ring, and that no
/// LED shines in red, green or blue.
Check ringInOneColor(Bench& bench) {
  Check check{"one_color_of_the_other", {bench.cameraDevice()}, "", {}, {}};
  const auto seen = [&bench] { return bench.see(kOneColor).has_value(); };
  check.stages.push_back({"seeing LEDs in " + toString(kOneColor), kSightPatience, nullptr, nullptr, seen, nullptr});
  check.stages.push_back(settle(bench, [&bench] {
    const Surroundings& place = bench.surroundings();
    const std::vector<Eigen::Vector2d> shown = bench.placesOf(kOneColor);
    double width = 0.0;
    for (const Eigen::Vector2d& one : shown) {
      for (const Eigen::Vector2d& other : shown) {
        width = std::max(width, (one - other).norm());
      }
    }
    constexpr double kLength = 0.03;  // m
    bench.expectTrue(
        "half of its LEDs at the least shine in " + toString(kOneColor) + "; found " + std::to_string(shown.size()),
        2 * (shown.size() + 1) >= place.observed_leds);
    bench.expectNear("from the one end of the ring to the other", width, 2.0 * place.observed_radius, kLength, "m");
    bench.expectTrue("no LED shines in red, green or blue",
                     !bench.see(colors::kRed) && !bench.see(colors::kGreen) && !bench.see(colors::kBlue));
  }));
  return check;
}

}  // namespace

std::vector<Check> observerChecks(Bench& bench) {
  std::vector<Check> checks;
  for (const DeviceChecks& device : deviceChecks()) {
    if (device.observe != nullptr && bench.isListed(device.device)) {
      for (Check& check : device.observe(bench)) {
        checks.push_back(std::move(check));
      }
    }
  }
  const bool sees = !bench.cameraDevice().empty() && bench.surroundings().observed_leds > 0;
  if (sees || checks.empty()) {
    Check ring = bench.surroundings().observes_one_color ? ringInOneColor(bench) : ringInThreeColors(bench);
    if (bench.cameraDevice().empty()) {
      ring.devices.clear();
      ring.obstacle = "no camera is listed";
    } else if (!sees) {
      ring.obstacle = "nobody is observed (observed_leds is 0)";
    }
    checks.insert(checks.begin(), std::move(ring));  // the ring shines only at the start
  }
  return checks;
}

}  // namespace swarmanoid::conformance
