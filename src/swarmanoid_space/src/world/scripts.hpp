/// Controllers and rules in Python.
#pragma once

#include <memory>

#include "world.hpp"

namespace swarmanoid {

/// @pre the description has a script @throws ConfigError for whatever is wrong with it
std::shared_ptr<GroupController> controllerInScript(World& world, const ControllerDescription& description);
std::shared_ptr<Rule> ruleInScript(World& world, const RuleDescription& description);

/// A run begins anew: whatever is made from now on is read anew.
void forgetScripts(World& world);

}  // namespace swarmanoid
