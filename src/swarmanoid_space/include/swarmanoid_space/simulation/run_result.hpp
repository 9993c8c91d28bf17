/// The result of a run, the source of the program's summary, and of the message and the log line under ROS.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_space/simulation/simulation.hpp"
#include "swarmanoid_space/state/overflow.hpp"

namespace swarmanoid {

/// The part of a result that is known only to the caller that ends the run.
struct RunEnd {
  bool finished = false;                    ///< reached its end; false: was stopped
  std::string message;                      ///< why it was stopped; "" if there is nothing to say
  double wall_s = 0.0;                      ///< wall time of the run [s]
  std::optional<std::uint64_t> state_hash;  ///< of the last tick; nothing: computed from the simulation
};

struct RunResult {
  std::string experiment;
  std::uint64_t seed = 0;
  std::uint64_t run = 0;     ///< incremented by resets
  std::uint64_t ticks = 0;   ///< finished ticks
  double simulated_s = 0.0;  ///< [s]
  bool finished = false;
  std::string message;
  std::optional<bool> success;  ///< nothing: no rule or observer judges
  Metrics metrics;
  std::vector<ControllerFailure> failures;
  std::vector<Overflow> overflows;
  std::uint64_t state_hash = 0;
  double wall_s = 0.0;  ///< [s]
};

RunResult resultOf(const Simulation& simulation, const RunEnd& end);

}  // namespace swarmanoid
