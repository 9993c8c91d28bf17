/// Simulated time: integer nanoseconds, so that a sum of ticks is exact and the same on every machine.
///
/// The clock starts at kEpoch, one second after zero: ROS takes zero for "no time yet", and rosbag refuses it.
/// On a robot the same types carry ROS time.
#pragma once

#include <chrono>
#include <cstdint>

namespace swarmanoid {

using Duration = std::chrono::nanoseconds;

/// The clock of a simulation. It has no now(): time is passed as an argument.
struct SimulationClock {
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<SimulationClock, Duration>;
  static constexpr bool is_steady = true;  // NOLINT(readability-identifier-naming): the standard's name
};

using Time = SimulationClock::time_point;

constexpr Time kEpoch{std::chrono::seconds(1)};

/// @return seconds
constexpr double toSeconds(Duration duration) { return static_cast<double>(duration.count()) * 1e-9; }

/// @return seconds since time zero (not since kEpoch)
constexpr double toSeconds(Time time) { return toSeconds(time.time_since_epoch()); }

}  // namespace swarmanoid
