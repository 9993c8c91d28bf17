/// Access to the engines of a running world: their reports and parameters.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/world/engine_report.hpp"
#include "world.hpp"

namespace swarmanoid {

/// Index of the engine in the experiment. @throws ConfigError if there is none
std::size_t engineIndex(const World& world, const std::string& id);

/// @param index see engineIndex @param parameters of the engine from now on
void reconfigureEngine(World& world, std::size_t index, Configuration parameters);

/// Resets the parameters of all engines to those of the file.
void restoreEngineParameters(World& world);

/// In the order of Space::engines. Allocates.
std::vector<EngineReport> reportEngines(const World& world);

}  // namespace swarmanoid
