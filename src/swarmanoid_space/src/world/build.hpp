/// Builds the state before tick 0 from an experiment's description, and clears it.
#pragma once

#include "world.hpp"

namespace swarmanoid {

/// Builds the engines, once per world. @throws ConfigError
void buildEngines(World& world);

/// Builds everything in the space, with robots and their controllers. @pre the engines are built @throws ConfigError
void build(World& world);

/// Builds the controller groups with their devices, without robots. Part of `build`. @throws ConfigError
void buildControllerGroups(World& world);

/// Initialises the controller of a group that is stepped together. @throws ConfigError for any exception of it
void initTogether(const ControllerGroup& group);

/// Builds the rules, once per world, after the engines. @throws ConfigError
void buildRules(World& world);

/// Creates Python rules anew for a new run; C++ rules have a reset function. @throws ConfigError
void renewRulesInScripts(World& world);

/// Builds the observers, once per world, last. @throws ConfigError
void buildObservers(World& world);

/// Builds the handover rules of the file, one trigger for each of their entities. Part of `build`. @throws ConfigError
void buildTriggers(World& world);

/// Ends all controllers and empties the space; engines and observers stay.
void unbuild(World& world);

}  // namespace swarmanoid
