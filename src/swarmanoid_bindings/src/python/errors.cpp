#include "errors.hpp"

#include "swarmanoid_interface/configuration.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

PyObject* rule_error = nullptr;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables): a class of the module

/// Adds an exception class. Exception classes live as long as the process, since errors are translated until its end.
PyObject* add(py::module_& module, const char* name, const char* text, PyObject* base) {
  const std::string full = std::string("swarmanoid.") + name;
  PyObject* const error = PyErr_NewExceptionWithDoc(full.c_str(), text, base, nullptr);
  module.add_object(name, error);
  return error;
}

/// Raises an error in an experiment, with its file and line.
void raise(const ConfigError& error, PyObject* type) {
  const py::object exception = py::reinterpret_borrow<py::object>(type)(error.what());
  exception.attr("file") = error.location().file;
  exception.attr("line") = error.location().line;
  PyErr_SetObject(type, exception.ptr());
}

}  // namespace

PyObject* ruleError() { return rule_error; }

std::string describe(const py::error_already_set& error) {
  const py::object trace = error.trace() ? error.trace() : py::none();
  return py::str(py::module_::import("swarmanoid._scripts").attr("describe")(error.value(), trace));
}

void bindErrors(py::module_& module) {
  static PyObject* const experiment_error =
      add(module, "ExperimentError", "A mistake in an experiment: `file` and `line` say where.", PyExc_ValueError);
  static PyObject* const intervention_error =
      add(module, "InterventionError", "What was asked for cannot be done; the world is as it was.", PyExc_ValueError);
  rule_error =
      add(module, "RuleError", "A rule in Python has thrown its __cause__; the run is over.", PyExc_RuntimeError);
  // by value: pybind11 prescribes the signature
  py::register_exception_translator([](std::exception_ptr pointer) {  // NOLINT(performance-unnecessary-value-param)
    try {
      if (pointer) {
        std::rethrow_exception(pointer);
      }
    } catch (const ConfigError& error) {
      raise(error, experiment_error);
    } catch (const InterventionError& error) {
      PyErr_SetString(intervention_error, error.what());
    }
  });
}

}  // namespace swarmanoid::bindings
