/// How often something may be done, in wall time.
#pragma once

#include <chrono>

namespace swarmanoid {

class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param rate at most so many times a second [Hz]; 0: always
  explicit Pace(double rate)
      : interval_(rate > 0.0 ? std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / rate))
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
  Clock::duration interval_;
  Clock::time_point next_ = Clock::time_point::min();
};

}  // namespace swarmanoid
