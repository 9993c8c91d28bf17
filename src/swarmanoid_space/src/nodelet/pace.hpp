/// How often something may be done, in wall time.
#pragma once

#include <algorithm>
#include <chrono>

namespace swarmanoid {

class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param rate at most so many times a second [Hz]; 0: always
  explicit Pace(double rate)
      : interval_(rate > 0.0 ? std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(std::min(1.0 / rate, kLongest)))
                             : Clock::duration::zero()) {}

  /// Whether it may be done now; counts as done then.
  bool isDue(Clock::time_point now) {
    if (now < next_) {
      return false;
    }
    next_ = now + interval_;
    return true;
  }

 private:
  static constexpr double kLongest = 1e9;  // s: more would not fit

  Clock::duration interval_;
  Clock::time_point next_ = Clock::time_point::min();
};

}  // namespace swarmanoid
