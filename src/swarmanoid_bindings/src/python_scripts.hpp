/// Controllers and rules in Python that stand in a file which the experiment names (source="python").
///
/// A part is what the file has under the name of its tag: of controllers a function or an object of all robots, or a
/// class of one; of rules an object, or a class that makes one. A file is read once a run, for all of its parts; runs
/// share neither the file's module nor those that it imports from its folder (_scripts.py).
#pragma once

#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <set>
#include <string>

#include "moment.hpp"
#include "swarmanoid_space/script_host.hpp"
#include "thrown.hpp"

namespace swarmanoid::bindings {

class PythonScripts final : public ScriptHost {
 public:
  PythonScripts(std::shared_ptr<Moment> moment, std::shared_ptr<Thrown> thrown)
      : moment_(std::move(moment)), thrown_(std::move(thrown)) {}
  ~PythonScripts() override;
  PythonScripts(const PythonScripts&) = delete;
  PythonScripts& operator=(const PythonScripts&) = delete;

  // Each takes Python's lock.
  std::shared_ptr<GroupController> makeController(const ControllerDescription& description) override;
  std::shared_ptr<Rule> makeRule(const RuleDescription& description) override;
  void forget() override;

 private:
  pybind11::object find(const char* what, const std::string& file, const std::string& name,
                        const SourceLocation& location);

  /// @throws ConfigError if an object that is given parameters has another owner already
  void takeObject(const pybind11::object& object, const std::string& name, const SourceLocation& location);

  std::shared_ptr<Moment> moment_;
  std::shared_ptr<Thrown> thrown_;
  std::map<std::string, pybind11::object> scripts_;  // Script of _scripts.py, by file
  std::set<PyObject*> taken_;                        // objects that have an owner
};

/// For a simulation in Python: what controllers throw stops their robots, as with those in C++.
/// @param thrown of the simulation, which gets what rules throw, and Ctrl-C
std::shared_ptr<ScriptHost> makeScriptsOfPython(std::shared_ptr<Moment> moment, std::shared_ptr<Thrown> thrown);

/// For a process in which no code in Python makes the ticks.
std::shared_ptr<ScriptHost> makeScriptsOfProgram();

/// A controller of all robots, or one for each if it is a class. @throws pybind11::type_error if it is neither
std::shared_ptr<GroupController> makeController(const pybind11::object& controller,
                                                const ControllerDescription& description,
                                                const std::shared_ptr<Moment>& moment,
                                                const std::shared_ptr<Thrown>& thrown);

}  // namespace swarmanoid::bindings
