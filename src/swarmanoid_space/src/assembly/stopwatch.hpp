/// Measures wall time between laps; a disabled stopwatch does nothing.
#pragma once

#include <chrono>

namespace swarmanoid {

class Stopwatch {
 public:
  /// @param is_running false: the stopwatch never reads the clock, which takes tens of nanoseconds each time
  explicit Stopwatch(bool is_running) : is_running_(is_running) {
    if (is_running) {
      last_ = std::chrono::steady_clock::now();
    }
  }

  /// @param seconds gets the time since the last lap or the construction; 0 if the stopwatch is disabled
  void lap(double& seconds) {
    if (!is_running_) {
      seconds = 0.0;
      return;
    }
    const auto now = std::chrono::steady_clock::now();
    seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

 private:
  bool is_running_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace swarmanoid
