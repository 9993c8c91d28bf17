/// The exceptions of the package, derived from Python's own: ExperimentError and InterventionError are ValueErrors,
/// RuleError is a RuntimeError.
#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>

namespace swarmanoid::bindings {

/// A rejected intervention in a running world. Becomes InterventionError in Python.
class InterventionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The class RuleError, for errors in Python rules. @pre bindErrors was called
PyObject* ruleError();

/// A Python exception in one line with its location: "ValueError: found 3 (/home/me/shy.py:7)".
/// @pre the GIL is held
std::string describe(const pybind11::error_already_set& error);

/// Adds the exceptions to the module. ConfigError becomes ExperimentError, with `file` and `line`.
void bindErrors(pybind11::module_& module);

}  // namespace swarmanoid::bindings
