#pragma once

#include <deque>

namespace swarmanoid {

/// Tells how fast simulated time goes, from looks at it. Over some seconds: a look finds whole ticks only.
class SpeedMeter {
 public:
  /// For whoever has paused, or changed the pace.
  void restart() { looks_.clear(); }

  /// @param real, simulated the two times of this look [s]; simulated time that goes back starts anew
  /// @return simulated seconds for each real one; 0 while nobody can tell
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
