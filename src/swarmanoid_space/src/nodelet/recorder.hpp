/// Files that parameters of the space ask for, beside those of the experiment file. Written in process and attached
/// before the first tick, so no tick is missing.
#pragma once

#include <string>

#include "space_options.hpp"
#include "swarmanoid_space/simulation.hpp"

namespace swarmanoid {

/// Records a bag.
/// @param options say the bag, relative to the out folder of the run, and whose controllers are in it
/// @param space name of the space's node, for topics
/// @return the bag's full name @throws ConfigError
std::string record(Simulation& simulation, const RunContext& context, const SpaceOptions& options,
                   const std::string& space);

/// Writes the state hash of every tick.
/// @param file relative to the out folder of the run
/// @return the file's full name @throws ConfigError
std::string writeHashes(Simulation& simulation, const RunContext& context, const std::string& file);

}  // namespace swarmanoid
