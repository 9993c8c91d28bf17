/// Parts that are supplied to a simulation from outside instead of being made from the registry.
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

/// Maps by id. Nodelets supply engines and controllers; the Python bindings supply group controllers and rules.
struct SuppliedParts {
  std::map<std::string, std::shared_ptr<Engine>> engines;  ///< already configured
  std::map<std::string, std::function<std::shared_ptr<Controller>()>> controllers;
  /// Replace the controllers that the experiment file names for these configurations.
  std::map<std::string, std::shared_ptr<GroupController>> group_controllers;
  /// Called after the rules of the experiment file, in this order, and configured without parameters; a rule with the
  /// id of a rule of the file replaces that one and gets its parameters.
  std::vector<std::pair<std::string, std::shared_ptr<Rule>>> rules;
  std::shared_ptr<ScriptHost> scripts;       ///< null: the suite's own host is loaded if any part is in Python
  std::shared_ptr<CommandMailbox> commands;  ///< for robots commanded over topics; null: there are none
};

}  // namespace swarmanoid
