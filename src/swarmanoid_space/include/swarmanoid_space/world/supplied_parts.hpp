/// What may be supplied to a simulation from outside instead of being made from the registry.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_interface/command_mailbox.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/group_controller.hpp"
#include "swarmanoid_space/rule.hpp"
#include "swarmanoid_space/script_host.hpp"

namespace swarmanoid {

/// By id. Nodelets supply engines and controllers, the bindings to Python controllers of groups, and rules.
struct SuppliedParts {
  std::map<std::string, std::shared_ptr<Engine>> engines;  ///< already configured
  std::map<std::string, std::function<std::shared_ptr<Controller>()>> controllers;
  /// Instead of the controller that the experiment file names for the configuration.
  std::map<std::string, std::shared_ptr<GroupController>> group_controllers;
  /// Called after those of the experiment file, in this order, and configured without parameters; one that has the id
  /// of a rule of the file stands in its place, and is given its parameters.
  std::vector<std::pair<std::string, std::shared_ptr<Rule>>> rules;
  std::shared_ptr<ScriptHost> scripts;       ///< null: if anything is in Python, the suite's own is loaded
  std::shared_ptr<CommandMailbox> commands;  ///< for robots commanded over topics; null: there are none
};

}  // namespace swarmanoid
