/// Limits how often an action is done, in wall time.
#pragma once

#include <algorithm>
#include <chrono>

namespace swarmanoid {

class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param rate maximum rate [Hz]; 0: no limit
  explicit Pace(double rate)
      : interval_(rate > 0.0 ? std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(std::min(1.0 / rate, kLongest)))
                             : Clock::duration::zero()) {}

  /// Returns whether the action is due now, and counts it as done if so.
  bool isDue(Clock::time_point now) {
    if (now < next_) {
      return false;
    }
    next_ = now + interval_;
    return true;
  }

 private:
  static constexpr double kLongest = 1e9;  // s: a longer time would overflow

  Clock::duration interval_;
  Clock::time_point next_ = Clock::time_point::min();
};

}  // namespace swarmanoid
