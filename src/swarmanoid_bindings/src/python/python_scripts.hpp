/// Controllers and rules in a Python file that the experiment names (source="python").
///
/// The name of a part's tag selects an object of the file: for controllers a function or an object for all robots, or a
/// class for one robot; for rules an object, or a class that is instantiated. A file is read once per run, for all of
/// its parts; runs share neither the file's module nor the modules that it imports from its folder (_scripts.py).
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

  // Each acquires the GIL.
  std::shared_ptr<GroupController> makeController(const ControllerDescription& description) override;
  std::shared_ptr<Rule> makeRule(const RuleDescription& description) override;
  void forget() override;

 private:
  pybind11::object find(const char* what, const std::string& file, const std::string& name,
                        const SourceLocation& location);

  /// @throws ConfigError if an object that takes parameters is already used by another part
  void takeObject(const pybind11::object& object, const std::string& name, const SourceLocation& location);

  std::shared_ptr<Moment> moment_;
  std::shared_ptr<Thrown> thrown_;
  std::map<std::string, pybind11::object> scripts_;  // Script of _scripts.py, by file
  std::set<PyObject*> taken_;                        // objects used by a part
};

/// Script host for a simulation in Python: an exception in a controller stops its robots, as in C++.
/// @param thrown of the simulation; receives exceptions of rules, and Ctrl-C
std::shared_ptr<ScriptHost> makeScriptsOfPython(std::shared_ptr<Moment> moment, std::shared_ptr<Thrown> thrown);

/// Script host for a process in which no Python code makes the ticks.
std::shared_ptr<ScriptHost> makeScriptsOfProgram();

/// A controller of all robots, or of each robot if it is a class. @throws pybind11::type_error if it is no controller
std::shared_ptr<GroupController> makeController(const pybind11::object& controller,
                                                const ControllerDescription& description,
                                                const std::shared_ptr<Moment>& moment,
                                                const std::shared_ptr<Thrown>& thrown);

}  // namespace swarmanoid::bindings
