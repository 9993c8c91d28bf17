/// What urdfdom takes and this suite cannot do, or no body can have: refused by name instead of ignored.
#pragma once

#include <vector>

#include "read_urdf.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid {

/// @return all such mistakes, with their lines: joints that slide or follow others, masses beyond limits::kMass,
/// inertias that no distribution of mass has
std::vector<ConfigError> mistakesIn(const UrdfFile& urdf);

}  // namespace swarmanoid
