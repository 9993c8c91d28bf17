/// The check of sensors that measure distances in directions of their own: those that look to the right measure the
/// wall there. Where on the robot they sit is not known.
#pragma once

#include <cmath>
#include <string>

#include "checks.hpp"
#include "swarmanoid_interface/angle.hpp"

namespace swarmanoid::conformance {

/// Judges all sensors, or beams, that look level and at most 0.5 rad from the right.
class WallOnTheRight {
 public:
  /// @param part that looks: "sensor", "beam"
  WallOnTheRight(Bench& bench, const char* part) : bench_(bench), part_(part) {}

  /// The next one. @param angle in the robot's frame [rad] @param distance that it measures [m]
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
  /// The next one does not look level.
  void skip() { ++number_; }
  void end() { bench_.expectTrue("some " + std::string(part_) + " looks to the right", looking_ > 0); }

 private:
  Bench& bench_;
  const char* part_;
  std::size_t number_ = 0;
  std::size_t looking_ = 0;
};

}  // namespace swarmanoid::conformance
