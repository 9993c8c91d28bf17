/// Experiments that Python names: a file, an installed experiment or a text, with values in place of those in it.
///
/// Threads  the GIL must be held.
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid::bindings {

struct ExperimentSource {
  std::optional<std::string> experiment;  ///< a file, or the name of an installed experiment
  std::optional<std::string> text;        ///< or its text
  std::optional<std::uint64_t> seed;
  std::optional<std::int64_t> ticks;
  std::optional<std::int64_t> threads;
  std::map<std::string, pybind11::object> overrides;  ///< values by path
  bool may_write = false;                             ///< false: observers that would write files are left out
};

/// Reads an experiment; its warnings become warnings of Python.
/// @throws pybind11::type_error if there is neither a file nor a text, or both; ConfigError
Experiment read(const ExperimentSource& source);

}  // namespace swarmanoid::bindings
