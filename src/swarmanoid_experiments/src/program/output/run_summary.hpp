/// Builds the JSON object that a run prints at its end.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "swarmanoid_space/simulation/run_result.hpp"

namespace swarmanoid::program {

/// Facts about a run that the summary contains in addition to its result.
struct RunFacts {
  std::vector<std::string> overrides;  ///< options that replaced values of the file, as given: "--seed 7"
  double robot_ticks = 0.0;            ///< robots times ticks, summed over the run
};

nlohmann::ordered_json summarise(const RunResult& result, const RunFacts& facts);

/// Formats the summary as one line.
std::string toText(const nlohmann::ordered_json& summary);

}  // namespace swarmanoid::program
