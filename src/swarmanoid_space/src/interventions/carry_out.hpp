/// Carries out interventions, one file for each kind; asked.cpp has the common functions and the interventions that
/// rules request.
#pragma once

#include <string>

#include "../world/world.hpp"
#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

// Each returns whether anything changed, and adds what happened to the events of the next tick. Each throws a
// ConfigError if it refuses; then nothing has changed.
bool carryOut(World& world, const SpawnEntity& intervention);
bool carryOut(World& world, const DeleteEntity& intervention);
bool carryOut(World& world, const MoveEntity& intervention);
bool carryOut(World& world, const HandOverEntity& intervention);
bool carryOut(World& world, const SetEngineParameters& intervention);
bool carryOut(World& world, const SetCommandSource& intervention);
bool carryOut(World& world, const SetProperty& intervention);
bool carryOut(World& world, const PaintFloor& intervention);
bool carryOut(World& world, const SetFault& intervention);

/// Returns a robot with a controller, for any command source.
/// @throws ConfigError if there is none, with a suggestion of a similar name
RobotInstance& requireRobot(World& world, const std::string& name);

/// Carries out an intervention of any kind, and records it if it changes something.
/// @param asked_by, after_rules see TakenIntervention
/// @throws ConfigError if it is refused; then nothing has changed
void take(World& world, const Intervention& intervention, const std::string& asked_by, bool after_rules);

/// Carries out all requests of rules.
/// @throws std::runtime_error naming the rule if a request that must succeed (InterventionQueue::ask) is refused
void takeAsked(World& world);

}  // namespace swarmanoid
