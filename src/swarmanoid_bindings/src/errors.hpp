/// The exceptions of the package, all of them errors that Python knows too: ExperimentError and InterventionError are
/// ValueErrors, RuleError is a RuntimeError.
#pragma once

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>

namespace swarmanoid::bindings {

/// A request to a running world cannot be fulfilled. Becomes InterventionError.
class InterventionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The class of errors in rules that are written in Python. @pre bindErrors was called
PyObject* ruleError();

/// What Python has thrown, in one line with the place: "ValueError: found 3 (/home/me/shy.py:7)".
/// @pre Python's lock is held
std::string describe(const pybind11::error_already_set& error);

/// Adds the exceptions to the module. ConfigError becomes ExperimentError, with `file` and `line`.
void bindErrors(pybind11::module_& module);

}  // namespace swarmanoid::bindings
