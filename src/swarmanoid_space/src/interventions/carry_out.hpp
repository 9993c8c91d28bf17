/// Carries out interventions, a file for each kind; asked.cpp is what they share, and about those that rules ask for.
#pragma once

#include <string>

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
bool carryOut(World& world, const SetProperty& intervention);
bool carryOut(World& world, const PaintFloor& intervention);
bool carryOut(World& world, const SetFault& intervention);

/// A robot with a controller, whoever commands it.
/// @throws ConfigError if there is none, naming the one that may be meant
RobotInstance& requireRobot(World& world, const std::string& name);

/// Carries out an intervention of any kind; one that changes something is recorded.
/// @param asked_by, after_rules as TakenIntervention has them
/// @throws ConfigError if it is refused; then nothing has changed
void take(World& world, const Intervention& intervention, const std::string& asked_by, bool after_rules);

/// All that rules have asked for. @throws std::runtime_error that names who asked for something that is refused
void takeAsked(World& world);

}  // namespace swarmanoid
