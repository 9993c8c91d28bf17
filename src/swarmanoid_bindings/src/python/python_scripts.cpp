#include "python_scripts.hpp"

#include <pybind11/stl.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "errors.hpp"
#include "plugins/python_controller.hpp"
#include "plugins/python_robots.hpp"
#include "plugins/python_rule.hpp"
#include "python_lock.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

/// Makes a part whose deleter acquires the GIL: any thread may release the last reference.
template <class Part, class... Arguments>
std::shared_ptr<Part> makeLocked(Arguments&&... arguments) {
  return std::shared_ptr<Part>(new Part(std::forward<Arguments>(arguments)...), [](Part* part) {
    const PythonLock lock;
    delete part;
  });
}

/// Runs an action for a part of an experiment. @throws ConfigError with the text of a Python exception
template <class Action>
auto forPart(const SourceLocation& location, const Thrown& thrown, Action action) {
  try {
    return action();
  } catch (const py::type_error& error) {
    throw ConfigError(location, error.what());
  } catch (py::error_already_set& error) {
    if (thrown.isInterruption(error)) {
      throw;
    }
    throw ConfigError(location, describe(error));
  }
}

}  // namespace

PythonScripts::~PythonScripts() {
  try {
    forget();
  } catch (const std::exception&) {
    // ignored: the run is over and its results are complete
  }
}

py::object PythonScripts::find(const char* what, const std::string& file, const std::string& name,
                               const SourceLocation& location) {
  const std::string place = std::filesystem::absolute(file).lexically_normal().string();
  const auto known = scripts_.find(place);
  const py::object script =
      known != scripts_.end() ? known->second : py::module_::import("swarmanoid._scripts").attr("Script")(place);
  scripts_[place] = script;
  const py::object module = script.attr("module");
  if (!py::hasattr(module, name.c_str())) {
    throw ConfigError(location, unknownName(what, name, script.attr("names")().cast<std::vector<std::string>>()) +
                                    " (in " + file + ")");
  }
  return module.attr(name.c_str());
}

void PythonScripts::takeObject(const py::object& object, const std::string& name, const SourceLocation& location) {
  if (py::hasattr(object, "init") && !taken_.insert(object.ptr()).second) {
    throw ConfigError(location, "found the object '" + name +
                                    "' a second time, allowed: once, for it would have the parameters of the last one");
  }
}

std::shared_ptr<GroupController> PythonScripts::makeController(const ControllerDescription& description) {
  const PythonLock lock;
  return forPart(description.location, *thrown_, [&] {
    const py::object found = find("the controller", description.script, description.label, description.location);
    if (PyType_Check(found.ptr()) == 0) {
      takeObject(found, description.label, description.location);
    }
    return bindings::makeController(found, description, moment_, thrown_);
  });
}

std::shared_ptr<Rule> PythonScripts::makeRule(const RuleDescription& description) {
  const PythonLock lock;
  return forPart(description.location, *thrown_, [&]() -> std::shared_ptr<Rule> {
    py::object found = find("the rule", description.script, description.label, description.location);
    if (PyType_Check(found.ptr()) != 0) {
      found = found();
    } else {
      takeObject(found, description.label, description.location);
    }
    return makeLocked<PythonRule>(found, moment_, thrown_);
  });
}

void PythonScripts::forget() {
  const PythonLock lock;
  taken_.clear();
  for (auto& [file, script] : scripts_) {
    script.attr("forget")();
  }
  scripts_.clear();
}

std::shared_ptr<ScriptHost> makeScriptsOfPython(std::shared_ptr<Moment> moment, std::shared_ptr<Thrown> thrown) {
  auto of_scripts = std::make_shared<Thrown>();
  of_scripts->keeps = Thrown::Keeps::kInterruptions;
  of_scripts->interrupted = std::move(thrown);
  return makeLocked<PythonScripts>(std::move(moment), std::move(of_scripts));
}

std::shared_ptr<ScriptHost> makeScriptsOfProgram() {
  auto thrown = std::make_shared<Thrown>();
  thrown->keeps = Thrown::Keeps::kNothing;
  return makeLocked<PythonScripts>(std::make_shared<Moment>(), std::move(thrown));
}

std::shared_ptr<GroupController> makeController(const py::object& controller, const ControllerDescription& description,
                                                const std::shared_ptr<Moment>& moment,
                                                const std::shared_ptr<Thrown>& thrown) {
  if (PyType_Check(controller.ptr()) != 0) {
    return makeLocked<PythonRobots>(controller, description, moment, thrown);
  }
  return makeLocked<PythonController>(controller, moment, thrown);
}

}  // namespace swarmanoid::bindings
