/// What makes controllers and rules that are written in Python out of the file that an experiment names for them
/// (source="python"). The bindings bring one, which is called in Python's own process as in one of C++.
///
/// Phases   when a world is built.
/// Threads  what it makes may be called, and destroyed, on any thread.
#pragma once

#include <memory>

#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/group_controller.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid {

class ScriptHost {
 public:
  virtual ~ScriptHost() = default;

  /// @pre the description has a script @throws ConfigError for what is wrong with the file, or is not in it
  virtual std::shared_ptr<GroupController> makeController(const ControllerDescription& description) = 0;
  virtual std::shared_ptr<Rule> makeRule(const RuleDescription& description) = 0;

  /// A run begins anew: files are read again by whatever is made from now on. What was made before is not called any
  /// more.
  virtual void forget() = 0;
};

using ScriptHostFactory = std::shared_ptr<ScriptHost> (*)();

/// For the library that has one, to be called while it is loaded.
void registerScriptHost(ScriptHostFactory factory);

/// A host for one simulation. @param location of what is in a script
/// @throws ConfigError if there is none, or it does not start
std::shared_ptr<ScriptHost> makeScriptHost(const SourceLocation& location);

}  // namespace swarmanoid
