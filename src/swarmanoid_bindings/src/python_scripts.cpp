#include "python_scripts.hpp"

#include <pybind11/stl.h>

#include <utility>
#include <vector>

#include "errors.hpp"
#include "python_controller.hpp"
#include "python_robots.hpp"
#include "python_rule.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

/// The last one to use it may be on any thread.
template <class Part, class... Arguments>
std::shared_ptr<Part> makeLocked(Arguments&&... arguments) {
  return std::shared_ptr<Part>(new Part(std::forward<Arguments>(arguments)...), [](Part* part) {
    const py::gil_scoped_acquire lock;
    delete part;
  });
}

/// Does something for a part of an experiment. @throws ConfigError with what Python throws
template <class Action>
auto forPart(const SourceLocation& location, Action action) {
  try {
    return action();
  } catch (const py::type_error& error) {
    throw ConfigError(location, error.what());
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_Exception)) {
      throw;  // Ctrl-C
    }
    throw ConfigError(location, describe(error));
  }
}

}  // namespace

py::object PythonScripts::find(const char* what, const std::string& file, const std::string& name,
                               const SourceLocation& location) {
  const auto known = modules_.find(file);
  const py::module_ scripts = py::module_::import("swarmanoid._scripts");
  const py::object module = known != modules_.end() ? known->second : py::object(scripts.attr("load")(file));
  modules_[file] = module;
  if (!py::hasattr(module, name.c_str())) {
    throw ConfigError(
        location,
        unknownName(what, name, scripts.attr("names")(module).cast<std::vector<std::string>>()) + " (in " + file + ")");
  }
  return module.attr(name.c_str());
}

std::shared_ptr<GroupController> PythonScripts::makeController(const ControllerDescription& description) {
  const py::gil_scoped_acquire lock;
  return forPart(description.location, [&] {
    const py::object found = find("the controller", description.script, description.label, description.location);
    return bindings::makeController(found, description, moment_, thrown_);
  });
}

std::shared_ptr<Rule> PythonScripts::makeRule(const RuleDescription& description) {
  const py::gil_scoped_acquire lock;
  return forPart(description.location, [&]() -> std::shared_ptr<Rule> {
    py::object found = find("the rule", description.script, description.label, description.location);
    if (PyType_Check(found.ptr()) != 0) {
      found = found();
    }
    return makeLocked<PythonRule>(found, moment_, thrown_);
  });
}

std::shared_ptr<ScriptHost> makePythonScripts(std::shared_ptr<Moment> moment, std::shared_ptr<Thrown> thrown) {
  return makeLocked<PythonScripts>(std::move(moment), std::move(thrown));
}

std::shared_ptr<ScriptHost> makeScriptsOfProgram() {
  auto thrown = std::make_shared<Thrown>();
  thrown->is_for_python = false;
  return makePythonScripts(std::make_shared<Moment>(), std::move(thrown));
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
