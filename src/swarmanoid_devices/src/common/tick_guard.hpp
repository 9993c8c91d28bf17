/// Detects the first call of a tick, for devices with state that lasts from tick to tick. A tick may be computed more
/// than once: it is sensed again after an action on the space, and actuated again by a safe stop. Each computation must
/// start from the state after the previous tick.
#pragma once

#include <cstdint>
#include <optional>

#include "swarmanoid_interface/state_archive.hpp"

namespace swarmanoid::devices {

/// State of one instance. Phases: `sense` of a sensor, `actuate` of an actuator. Not thread-safe, like the instance.
class TickGuard {
 public:
  /// @param tick Space::tick @return whether it differs from that of the last call: the device then advances its state
  bool begins(std::uint64_t tick) {
    const bool is_another = tick_ != tick;
    tick_ = tick;
    return is_another;
  }

  /// Whether `begins` has been called; if not, the instance was added after the last tick.
  bool hasBegun() const { return tick_.has_value(); }

  /// For snapshots.
  void archive(StateArchive& state) { state(tick_); }

 private:
  std::optional<std::uint64_t> tick_;
};

}  // namespace swarmanoid::devices
