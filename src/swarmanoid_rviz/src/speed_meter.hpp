#pragma once

#include <deque>

namespace swarmanoid {

/// Measures the speed of simulated time from samples over 5 s: samples see whole ticks only, so short spans are noisy.
class SpeedMeter {
 public:
  /// Clears the samples; to be called after a pause or a change of pace.
  void restart() { looks_.clear(); }

  /// @param real, simulated times of this sample [s]; simulated time that goes back restarts the measurement
  /// @return simulated seconds per real second; 0 while unknown
  double look(double real, double simulated) {
    constexpr double kSpan = 5.0;  // [s] real
    if (!looks_.empty() && simulated < looks_.back().simulated) {
      restart();
    }
    looks_.push_back({real, simulated});
    while (looks_.size() > 2 && real - looks_[1].real >= kSpan) {
      looks_.pop_front();
    }
    const double passed = real - looks_.front().real;
    return passed > 0.0 ? (simulated - looks_.front().simulated) / passed : 0.0;
  }

 private:
  struct Look {
    double real;
    double simulated;
  };
  std::deque<Look> looks_;
};

}  // namespace swarmanoid
