/// Checks of an experiment file without running code of others.
///
/// An experiment file is code: reading it loads the libraries that it names, and loading a library runs its code.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {

struct UncheckedExperiment {
  Experiment experiment;
  std::vector<std::string> libraries;  ///< named by the file and not loaded
};

/// Same as readExperiment, but loads no library. Checks structure, numbers, ids and everything that belongs to the
/// suite itself; does not check parameters of plugins from libraries.
/// @throws ConfigError
UncheckedExperiment readWithoutLibraries(const std::string& file, const std::vector<Override>& overrides = {});

}  // namespace swarmanoid
