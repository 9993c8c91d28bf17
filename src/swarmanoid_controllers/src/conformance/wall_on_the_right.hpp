/// The check of sensors that measure distances in known directions: those that face right measure the wall there. Their
/// positions on the robot are not known.
#pragma once

#include <cmath>
#include <string>

#include "checks.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::conformance {

/// Judges all level sensors, or beams, within 0.5 rad of the right.
class WallOnTheRight {
 public:
  /// @param part that measures: "sensor", "beam"
  WallOnTheRight(Bench& bench, const char* part) : bench_(bench), part_(part) {}

  /// Judges the next one. @param angle in the robot's frame [rad] @param distance measured [m]
  void look(float angle, float distance) {
    constexpr double kOff = 0.5;  // rad
    const double aside = static_cast<double>(angle) + M_PI / 2.0;
    if (std::abs(wrapAngle(aside)) < kOff) {
      ++looking_;
      const double wall = bench_.surroundings().wall_distance;
      bench_.expectNear("way from " + std::string(part_) + " " + std::to_string(number_) + " to the wall",
                        static_cast<double>(distance) * std::cos(aside), 0.65 * wall, 0.35 * wall, "m");
    }
    ++number_;
  }
  /// Skips the next one, which is not level.
  void skip() { ++number_; }
  void end() { bench_.expectTrue("some " + std::string(part_) + " looks to the right", looking_ > 0); }

 private:
  Bench& bench_;
  const char* part_;
  std::size_t number_ = 0;
  std::size_t looking_ = 0;
};

}  // namespace swarmanoid::conformance
