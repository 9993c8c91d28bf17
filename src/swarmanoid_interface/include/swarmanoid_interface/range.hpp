/// Bounds of numbers: parameters in experiment files, fields of devices, limits of the simulation.
#pragma once

#include <limits>
#include <string>

namespace swarmanoid {

/// Bounds of a number, inclusive.
struct Range {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();
  double smallest_magnitude = 0.0;  ///< of a number that is not 0

  bool contains(double value) const {
    const double size = value < 0.0 ? -value : value;
    return value >= minimum && value <= maximum && (size >= smallest_magnitude || size == 0.0);
  }
  /// Returns "from 0 to 1", "at least 0", "at most 1" or "any number"; with `smallest_magnitude`, "from 0 to 1 (0, or
  /// at least 0.1)".
  std::string toString() const;
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace swarmanoid
