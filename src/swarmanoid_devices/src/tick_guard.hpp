/// What a device that carries something from tick to tick needs, because a tick may be computed more than once: it is
/// sensed again after somebody has acted on the space, and actuated again by a safe stop. Each time it must begin with
/// what the tick before has left.
#pragma once

#include <cstdint>
#include <optional>

namespace swarmanoid::devices {

/// Of one instance. Phases: `sense` of a sensor, `actuate` of an actuator. Not thread-safe, as the instance is not.
class TickGuard {
 public:
  /// @param tick Space::tick @return whether it is another one than that of the last call: what is carried moves on
  bool begins(std::uint64_t tick) {
    const bool is_another = tick_ != tick;
    tick_ = tick;
    return is_another;
  }

  /// Whether there has been a call of `begins`: if not, the instance was added since the last tick.
  bool hasBegun() const { return tick_.has_value(); }

 private:
  std::optional<std::uint64_t> tick_;
};

}  // namespace swarmanoid::devices
