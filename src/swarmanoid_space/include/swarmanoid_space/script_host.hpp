/// Makes controllers and rules that are written in Python, from the file that an experiment names for them
/// (source="python"). The Python bindings provide the host, both inside a Python process and inside a C++ program.
///
/// Phases   when a world is built.
/// Threads  the objects that it makes may be called, and destroyed, on any thread.
#pragma once

#include <memory>

#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/group_controller.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid {

class ScriptHost {
 public:
  virtual ~ScriptHost() = default;

  /// @pre the description has a script @throws ConfigError if the file is invalid or lacks the class
  virtual std::shared_ptr<GroupController> makeController(const ControllerDescription& description) = 0;
  virtual std::shared_ptr<Rule> makeRule(const RuleDescription& description) = 0;

  /// Called when a run begins anew: later calls read the files again. Objects made before are not called any more.
  virtual void forget() = 0;
};

using ScriptHostFactory = std::shared_ptr<ScriptHost> (*)();

/// Registers the factory of the library that provides a host; called while the library is loaded.
void registerScriptHost(ScriptHostFactory factory);

/// A host for one simulation. @param location of the element that names the script
/// @throws ConfigError if there is no host, or it does not start
std::shared_ptr<ScriptHost> makeScriptHost(const SourceLocation& location);

}  // namespace swarmanoid
