/// Arguments that Python gives for a run, and the output that they ask for.
///
/// Threads  the GIL must be held.
#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiment_source.hpp"
#include "run.hpp"
#include "swarmanoid_recording/output/run_files.hpp"

namespace swarmanoid::bindings {

struct RunOptions {
  ExperimentSource source;
  PythonParts parts;
  std::optional<std::string> out;
  OutFolder::Rules rules;  ///< of the folder `out`
};

/// Rules in the order of the dictionary.
std::vector<std::pair<std::string, pybind11::object>> rulesIn(const pybind11::dict& rules);

/// The context of a run in process, with the folder `out`; once the run is made, OutFolder::keep follows.
RunContext contextOf(const RunOptions& options, const Experiment& experiment);

}  // namespace swarmanoid::bindings
