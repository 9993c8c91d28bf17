/// The one JSON object that a run ends with.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::program {

/// What the summary says of a run beside what the simulation knows.
struct RunFacts {
  std::vector<std::string> overrides;  ///< options that replaced what the file says, as given: "--seed 7"
  bool finished = false;
  double wall_s = 0.0;                      ///< spent in ticks [s]
  double robot_ticks = 0.0;                 ///< robots times ticks, summed over the run
  std::optional<std::uint64_t> state_hash;  ///< of the last tick; none: as the simulation is
  std::vector<ControllerFailure> failures;  ///< of controllers
};

nlohmann::ordered_json summarise(const Simulation& simulation, const RunFacts& facts);

/// In one line.
std::string toText(const nlohmann::ordered_json& summary);

}  // namespace swarmanoid::program
