/// Converts the world state, which every bag has, to fields, for bags without the named state.
#pragma once

#include <swarmanoid_msgs/WorldState.h>

#include "recorded_tick.hpp"

namespace swarmanoid::diff {

/// Fields have the names of swarmanoid_msgs/NamedState.
StateFields worldFields(const swarmanoid_msgs::WorldState& state);

}  // namespace swarmanoid::diff
