/// Observers of a run that come from options of the command line instead of the experiment file.
#pragma once

#include <cstdint>
#include <string>

#include "swarmanoid_space/intervention.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::program {

/// Returns the absolute path of a file that an option names: such a path is relative to the current folder, not to the
/// run's folder. An empty name stays empty.
std::string fullName(const std::string& file);

/// Adds an observer that writes a file. @param label of the observer @param others its further parameters
/// @throws ConfigError
void addFromCommandLine(Simulation& simulation, const RunContext& context, const std::string& option,
                        const std::string& label, const std::string& file, const NamedValues& others = {});

/// Adds an observer that writes pictures of the whole arena. @throws ConfigError
void addFrames(Simulation& simulation, const RunContext& context, const std::string& folder, std::uint64_t every);

}  // namespace swarmanoid::program
