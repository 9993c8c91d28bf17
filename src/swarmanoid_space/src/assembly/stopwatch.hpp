/// Measures wall time, lap after lap.
#pragma once

#include <chrono>

namespace swarmanoid {

class Stopwatch {
 public:
  /// @param seconds gets the time since the last lap, or since the watch was made
  void lap(double& seconds) {
    const auto now = std::chrono::steady_clock::now();
    seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
  }

  /// When the last lap ended.
  std::chrono::steady_clock::time_point last() const { return last_; }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace swarmanoid
