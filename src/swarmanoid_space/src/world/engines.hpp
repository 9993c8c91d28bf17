/// Access to the engines of a running world: their reports and parameters.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_space/world/engine_report.hpp"
#include "world.hpp"

namespace swarmanoid {

/// Index of the engine in the experiment. @throws ConfigError if there is none
std::size_t engineIndex(const World& world, const std::string& id);

/// The present parameters of an engine. @param index see engineIndex
const Configuration& parametersOf(const World& world, std::size_t index);

/// @param index see engineIndex @param parameters of the engine from now on; null: those of the file
void reconfigureEngine(World& world, std::size_t index, std::shared_ptr<const Configuration> parameters);

/// Resets the parameters of all engines to those of the file.
void restoreEngineParameters(World& world);

/// In the order of Space::engines. Allocates.
std::vector<EngineReport> reportEngines(const World& world);

}  // namespace swarmanoid
