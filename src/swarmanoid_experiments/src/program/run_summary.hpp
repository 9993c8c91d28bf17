/// The one JSON object that a run ends with.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "swarmanoid_space/simulation/run_result.hpp"

namespace swarmanoid::program {

/// What the summary says of a run beside its result.
struct RunFacts {
  std::vector<std::string> overrides;  ///< options that replaced what the file says, as given: "--seed 7"
  double robot_ticks = 0.0;            ///< robots times ticks, summed over the run
};

nlohmann::ordered_json summarise(const RunResult& result, const RunFacts& facts);

/// In one line.
std::string toText(const nlohmann::ordered_json& summary);

}  // namespace swarmanoid::program
