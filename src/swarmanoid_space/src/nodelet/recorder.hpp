/// Recording in process: attached before the first tick, so no tick is missing.
#pragma once

#include <string>

#include "swarmanoid_space/simulation.hpp"

namespace swarmanoid {

/// @param file relative to the out folder of the run
/// @param space name of the space's node, for topics
/// @return the bag's full name @throws ConfigError
std::string record(Simulation& simulation, const RunContext& context, const std::string& file,
                   const std::string& space);

}  // namespace swarmanoid
