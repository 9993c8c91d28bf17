/// Exceptions of Python code that the simulation called, kept until control returns to Python.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>

namespace swarmanoid::bindings {

struct Thrown {
  enum class Keeps {
    kAll,            ///< all exceptions, for the Python caller of the ticks
    kInterruptions,  ///< Ctrl-C and exceptions of rules; others are failures of their controller, as in C++
    kNothing         ///< no Python code makes the ticks, so Ctrl-C is not handled by Python
  };

  Keeps keeps = Keeps::kAll;
  std::shared_ptr<Thrown> interrupted;  ///< for kInterruptions: stores the kept exceptions
  std::optional<pybind11::error_already_set> error;
  std::string rule_text;  ///< message of the RuleError that has `error` as its cause; "": not from a rule

  /// Keeps the first exception. @return whether it is a failure of the part that threw it
  bool keep(pybind11::error_already_set&& thrown, const std::string& of_rule = "");

  /// Whether the exception is Ctrl-C, which the caller of the ticks gets.
  bool isInterruption(const pybind11::error_already_set& thrown) const {
    return keeps != Keeps::kNothing && thrown.matches(PyExc_KeyboardInterrupt);
  }

  /// Whether an exception is pending: then no more Python code is called, and ticks stop until the caller gets it.
  bool isOver() const { return error.has_value() || (interrupted != nullptr && interrupted->isOver()); }

  /// Clears the kept exception and throws it, if there is one. @pre the GIL is held
  void raise();
};

}  // namespace swarmanoid::bindings
