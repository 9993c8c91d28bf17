/// Engines of a running world as seen from outside: how they are, and what they work with.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/world/engine_report.hpp"
#include "world.hpp"

namespace swarmanoid {

/// Its place in the experiment. @throws ConfigError if there is none
std::size_t engineIndex(const World& world, const std::string& id);

/// @param index as above @param parameters what the engine works with from now on
void reconfigureEngine(World& world, std::size_t index, Configuration parameters);

/// The parameters of all engines are those of the file again.
void restoreEngineParameters(World& world);

/// In the order of Space::engines. Allocates.
std::vector<EngineReport> reportEngines(const World& world);

}  // namespace swarmanoid
