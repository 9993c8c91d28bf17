/// What a run is made of, for Python: to compare runs of different days and computers, and to write an experiment down.
#pragma once

#include <pybind11/pybind11.h>

#include "run.hpp"

namespace swarmanoid::bindings {

/// A dictionary: `text` of the experiment with its overrides, `files` that it names (bytes by the name that the text
/// has for them), `libraries` (hashes by name), `math_library`, `file` (where the experiment was read).
/// @throws ConfigError if a file cannot be read any more
pybind11::dict recordOfRun(const Run& run);

}  // namespace swarmanoid::bindings
