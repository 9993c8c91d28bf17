/// Places many entities of one kind, at random or in rows.
#pragma once

#include <vector>

#include "world.hpp"

namespace swarmanoid {

/// @param group with a distribution @throws ConfigError if there is not enough room
void distribute(World& world, const EntityDescription& group, const std::vector<Membership>& memberships);

}  // namespace swarmanoid
