/// Observers of a run that options of the command line ask for, not the experiment file.
#pragma once

#include <cstdint>
#include <string>

#include "swarmanoid_space/intervention.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::program {

/// Returns the absolute name of a file that an option names: those are relative to the current folder, not to that of
/// the run. An empty name stays empty.
std::string fullName(const std::string& file);

/// Adds an observer that writes a file. @param label of the observer @param others more of its parameters
/// @throws ConfigError
void addFromCommandLine(Simulation& simulation, const RunContext& context, const std::string& option,
                        const std::string& label, const std::string& file, const NamedValues& others = {});

/// Adds what writes pictures of the whole arena. @throws ConfigError
void addFrames(Simulation& simulation, const RunContext& context, const std::string& folder, std::uint64_t every);

}  // namespace swarmanoid::program
