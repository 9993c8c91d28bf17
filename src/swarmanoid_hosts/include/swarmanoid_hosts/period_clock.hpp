/// A clock of periods of equal length on a grid: it returns the start of each period, and counts those that were missed
/// because a step took too long. Missed periods are skipped, never made up for.
#pragma once

#include <algorithm>
#include <cstdint>

#include "swarmanoid_interface/expects.hpp"
#include "swarmanoid_interface/time.hpp"

namespace swarmanoid {

class PeriodClock {
 public:
  /// The first period begins at `start`, on any clock of the caller.
  PeriodClock(Duration start, Duration period) : start_(start), period_(period) {}

  /// Returns the time at which the next period begins.
  Duration next() const { return start_ + static_cast<Duration::rep>(begun_) * period_; }

  /// Begins a period. @pre now is at least `next` @return the number of periods that have passed: 1, and each that was
  /// missed
  std::uint64_t begin(Duration now) {
    SWARMANOID_EXPECTS(now >= next());
    const auto on_grid = static_cast<std::uint64_t>((now - start_) / period_) + 1;
    const std::uint64_t passed = std::max<std::uint64_t>(1, on_grid - std::min(on_grid, begun_));
    begun_ += passed;
    missed_ += passed - 1;
    return passed;
  }

  /// Returns the number of missed periods since the start.
  std::uint64_t missed() const { return missed_; }

 private:
  Duration start_;
  Duration period_;
  std::uint64_t begun_ = 0;
  std::uint64_t missed_ = 0;
};

}  // namespace swarmanoid
