/// What urdfdom takes and this suite cannot do, or no body can have: refused by name instead of ignored.
#pragma once

#include "read_urdf.hpp"

namespace swarmanoid {

/// @throws ConfigError with the line: joints that slide or follow others, masses beyond limits::kMass, inertias that no
/// distribution of mass has
void checkUrdf(const UrdfFile& urdf);

}  // namespace swarmanoid
