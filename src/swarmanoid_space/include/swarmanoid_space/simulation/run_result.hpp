/// The result of a run, from which the program's summary, and the message and the line of the log under ROS, follow.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_space/simulation/simulation.hpp"
#include "swarmanoid_space/state/overflow.hpp"

namespace swarmanoid {

/// The part of a result that is not in the simulation, but with the caller that ends it.
struct RunEnd {
  bool finished = false;                    ///< it came to its end; false: it was stopped
  std::string message;                      ///< why it was stopped; "" if there is nothing to say
  double wall_s = 0.0;                      ///< that it took [s]
  std::optional<std::uint64_t> state_hash;  ///< of the last tick; none: as the simulation is
};

struct RunResult {
  std::string experiment;
  std::uint64_t seed = 0;
  std::uint64_t run = 0;     ///< counted up by resets
  std::uint64_t ticks = 0;   ///< that are finished
  double simulated_s = 0.0;  ///< [s]
  bool finished = false;
  std::string message;
  std::optional<bool> success;  ///< nothing: no observer judges
  Metrics metrics;
  std::vector<ControllerFailure> failures;
  std::vector<Overflow> overflows;
  std::uint64_t state_hash = 0;
  double wall_s = 0.0;  ///< [s]
};

RunResult resultOf(const Simulation& simulation, const RunEnd& end);

}  // namespace swarmanoid
