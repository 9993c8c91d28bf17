/// Carries out interventions, a file for each kind.
#pragma once

#include "../world/world.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

// Each returns whether anything has changed; what has happened is added to the events of the next tick.
// Each throws a ConfigError if it refuses, and then nothing has changed.
bool carryOut(World& world, const SpawnEntity& intervention);
bool carryOut(World& world, const DeleteEntity& intervention);
bool carryOut(World& world, const MoveEntity& intervention);
bool carryOut(World& world, const HandOverEntity& intervention);
bool carryOut(World& world, const SetEngineParameters& intervention);
bool carryOut(World& world, const SetCommandSource& intervention);

}  // namespace swarmanoid
