/// Places many entities of one kind, at random or in rows.
#pragma once

#include <vector>

#include "world.hpp"

namespace swarmanoid {

/// @param group with a distribution @param is_again the entities exist already, and are moved to the places that they
/// would get from the seed of the space. This takes time by the square of the number of entities.
/// @throws ConfigError if there is not enough room
void distribute(World& world, const EntityDescription& group, const std::vector<Membership>& memberships,
                bool is_again = false);

}  // namespace swarmanoid
