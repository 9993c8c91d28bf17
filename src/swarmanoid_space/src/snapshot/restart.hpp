/// Starts a run anew with the objects of the last one: faster than building, with the same bits.
#pragma once

#include <memory>

#include "snapshot_data.hpp"

namespace swarmanoid {

/// The state that `restart` needs, of a world that has just been built. Null for worlds that have to be built anew:
/// with many entities, since placing them again takes time by the square of their number; with rules or several
/// controllers of the caller, whose members may outlive a run; with parts in scripts, which are loaded for each run; or
/// with parts whose state is not defined.
std::unique_ptr<const Snapshot::Data> startOf(World& world);

/// Makes the state that `build` makes with the seed of the space. @param start of any run of this world
/// @throws ConfigError as build
void restart(World& world, const Snapshot::Data& start);

}  // namespace swarmanoid
