/// Controllers and rules in Python.
#pragma once

#include <memory>

#include "world.hpp"

namespace swarmanoid {

/// @pre the description has a script @throws ConfigError for any mistake in it
std::shared_ptr<GroupController> controllerInScript(World& world, const ControllerDescription& description);
std::shared_ptr<Rule> ruleInScript(World& world, const RuleDescription& description);

/// Called at a reset: later calls read the scripts again.
void forgetScripts(World& world);

}  // namespace swarmanoid
