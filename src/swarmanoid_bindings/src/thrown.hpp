/// What code in Python has thrown while the simulation called it, kept until Python has the word again.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

namespace swarmanoid::bindings {

struct Thrown {
  bool is_for_python = true;  ///< else nothing is kept, for nobody in Python has called: all of it is an error
  std::optional<pybind11::error_already_set> error;
  std::string rule_text;  ///< of the RuleError that it becomes the cause of; "": no rule has thrown it

  /// Keeps the first one. @return whether it is an error: for Python, Ctrl-C and exits are not, and nobody fails by
  /// them
  bool keep(pybind11::error_already_set&& thrown, const std::string& of_rule = "") {
    const bool is_error = !is_for_python || thrown.matches(PyExc_Exception);
    if (!error && is_for_python) {
      error.emplace(std::move(thrown));
      rule_text = is_error ? of_rule : "";
    }
    return is_error;
  }

  /// Nothing is kept any more. @pre Python's lock is held @throws what was kept, if anything was
  void raise();
};

}  // namespace swarmanoid::bindings
