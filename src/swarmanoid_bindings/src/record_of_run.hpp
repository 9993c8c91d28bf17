/// Record of a run for Python: all inputs of the run, to compare runs and to archive experiments.
#pragma once

#include <pybind11/pybind11.h>

#include "run.hpp"

namespace swarmanoid::bindings {

/// A dictionary: `text` of the experiment with its overrides, `files` that it names (bytes by their name in the text),
/// `libraries` (hashes by name), `math_library`, `file` (path of the experiment file).
/// @throws ConfigError if a file can no longer be read
pybind11::dict recordOfRun(const Run& run);

}  // namespace swarmanoid::bindings
