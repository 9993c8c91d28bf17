/// Counter of a rule that judges a run by its output: the count, the count per minute, and the count that is enough.
#pragma once

#include <optional>

#include "swarmanoid_space/metrics.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

class Tally {
 public:
  Tally() = default;
  /// @param count, per_minute metrics of the rule @param enough count of a success, which ends the run; 0: not judged
  Tally(Metric& count, Metric& per_minute, double enough) : count_(&count), per_minute_(&per_minute), enough_(enough) {}

  void add() { count_->value += 1.0; }
  /// Called after each tick.
  void measure(const Space& space) {
    constexpr double kSecondsInMinute = 60.0;
    per_minute_->value = count_->value * kSecondsInMinute / toSeconds(space.time - kEpoch);
  }
  bool isEnough() const { return enough_ > 0.0 && count_->value >= enough_; }
  std::optional<bool> success() const { return enough_ > 0.0 ? std::optional<bool>(isEnough()) : std::nullopt; }

 private:
  Metric* count_ = nullptr;
  Metric* per_minute_ = nullptr;
  double enough_ = 0.0;
};

}  // namespace swarmanoid::devices
