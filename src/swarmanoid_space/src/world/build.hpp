/// From an experiment's description to its state before tick 0, and back.
#pragma once

#include "world.hpp"

namespace swarmanoid {

/// Once a world. @throws ConfigError
void buildEngines(World& world);

/// Everything in the space, with robots and their controllers. @pre there are engines @throws ConfigError
void build(World& world);

/// Once a world, after the engines. @throws ConfigError
void buildRules(World& world);

/// Those in Python begin as in a new run; those in C++ have a function for that. @throws ConfigError
void renewRulesInScripts(World& world);

/// Once a world, last. @throws ConfigError
void buildObservers(World& world);

/// The handover rules of the file, for each entity that they are about. Part of `build`. @throws ConfigError
void buildTriggers(World& world);

/// Ends all controllers and empties the space; engines and observers stay.
void unbuild(World& world);

}  // namespace swarmanoid
