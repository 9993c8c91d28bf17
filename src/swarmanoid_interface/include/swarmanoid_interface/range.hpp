/// Bounds of numbers: of parameters in experiment files, of fields of devices, of what can be simulated.
#pragma once

#include <limits>
#include <string>

namespace swarmanoid {

/// The bounds that a number must keep, both included.
struct Range {
  double minimum = -std::numeric_limits<double>::infinity();
  double maximum = std::numeric_limits<double>::infinity();

  bool contains(double value) const { return value >= minimum && value <= maximum; }
  /// Returns "from 0 to 1", "at least 0", "at most 1" or "any number".
  std::string toString() const;
};

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace swarmanoid
