/// The one JSON object that a run ends with.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "swarmanoid_space/simulation.hpp"

namespace swarmanoid::program {

/// Exit codes of `swarmanoid run` and `swarmanoid launch`.
enum ExitCode : int { kFinished = 0, kBadInput = 2, kControllerFailed = 3, kEngineStopped = 4, kInterrupted = 130 };

/// @param wall_s spent in ticks [s]; @param robot_ticks robots times ticks, summed over the run
nlohmann::ordered_json summarise(const Simulation& simulation, bool finished, double wall_s, double robot_ticks);

/// In one line.
std::string toText(const nlohmann::ordered_json& summary);

}  // namespace swarmanoid::program
