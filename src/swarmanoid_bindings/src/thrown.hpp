/// What code in Python has thrown while the simulation called it, kept until Python has the word again.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>

namespace swarmanoid::bindings {

struct Thrown {
  enum class Keeps {
    kAll,            ///< the caller of the ticks in Python gets it
    kInterruptions,  ///< Ctrl-C, and what ends the run: all else is a failure of the part that threw it, as in C++
    kNothing         ///< no code in Python makes the ticks: Ctrl-C is not Python's either
  };

  Keeps keeps = Keeps::kAll;
  std::shared_ptr<Thrown> interrupted;  ///< of kInterruptions: who keeps them
  std::optional<pybind11::error_already_set> error;
  std::string rule_text;  ///< of the RuleError that it becomes the cause of; "": no rule has thrown it

  /// Keeps the first one. @return whether it is a failure of who has thrown it
  bool keep(pybind11::error_already_set&& thrown, const std::string& of_rule = "");

  /// Whether Ctrl-C has been thrown, which is for the caller of the ticks.
  bool isInterruption(const pybind11::error_already_set& thrown) const {
    return keeps != Keeps::kNothing && thrown.matches(PyExc_KeyboardInterrupt);
  }

  /// No more code in Python is called in this tick, which is the last one until the caller has seen what was thrown.
  bool isOver() const { return error.has_value() || (interrupted != nullptr && interrupted->isOver()); }

  /// Nothing is kept any more. @pre Python's lock is held @throws what was kept, if anything was
  void raise();
};

}  // namespace swarmanoid::bindings
