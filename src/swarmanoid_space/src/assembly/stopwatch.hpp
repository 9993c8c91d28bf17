/// Measures wall time, lap after lap, if it is to.
#pragma once

#include <chrono>

namespace swarmanoid {

class Stopwatch {
 public:
  /// @param is_running else it never asks for the time, which takes tens of nanoseconds each time
  explicit Stopwatch(bool is_running) : is_running_(is_running) {
    if (is_running) {
      last_ = std::chrono::steady_clock::now();
    }
  }

  /// @param seconds gets the time since the last lap, or since the watch was made; 0 if it does not run
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
