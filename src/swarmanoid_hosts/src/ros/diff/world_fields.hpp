/// The world state that every bag has as fields, for bags without the named state.
#pragma once

#include <swarmanoid_msgs/WorldState.h>

#include "recorded_tick.hpp"

namespace swarmanoid::diff {

/// Named as in swarmanoid_msgs/NamedState.
StateFields worldFields(const swarmanoid_msgs::WorldState& state);

}  // namespace swarmanoid::diff
