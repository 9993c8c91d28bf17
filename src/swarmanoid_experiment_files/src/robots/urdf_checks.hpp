/// Checks for elements that urdfdom accepts but that this suite does not support or that are physically impossible.
/// They are refused by name instead of ignored.
#pragma once

#include <vector>

#include "swarmanoid_experiment_files/robots/read_urdf.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// @return all such mistakes, with their lines: joints that slide or follow others, masses beyond limits::kMass,
/// inertias that no mass distribution has
std::vector<ConfigError> mistakesIn(const UrdfFile& urdf);

}  // namespace swarmanoid
