/// Many entities of one kind, placed at random or in rows.
#pragma once

#include <vector>

#include "world.hpp"

namespace swarmanoid {

/// @param group with a distribution @throws ConfigError if there is no room
void distribute(World& world, const EntityDescription& group, const std::vector<Membership>& memberships);

}  // namespace swarmanoid
