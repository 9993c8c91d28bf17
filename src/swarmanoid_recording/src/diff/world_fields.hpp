/// Converts the world state, which every bag has, to fields, for bags without the named state.
#pragma once

#include <swarmanoid_msgs/WorldState.h>

#include <string>

#include "recorded_tick.hpp"

namespace swarmanoid::diff {

/// Fields have the names of swarmanoid_msgs/NamedState.
/// @param file of the bag @throws ConfigError if the numbers of poses, colours, ... differ from that of the names
StateFields worldFields(const swarmanoid_msgs::WorldState& state, const std::string& file);

}  // namespace swarmanoid::diff
