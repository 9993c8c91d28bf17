/// What can be checked of an experiment file without running code of others.
///
/// An experiment file is code: reading it loads the libraries that it names, and loading a library runs what is in it.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/experiment_file/experiment.hpp"

namespace swarmanoid {

struct UncheckedExperiment {
  Experiment experiment;
  std::vector<std::string> libraries;  ///< that the file names and that are not loaded
};

/// As readExperiment, but loads no library. Structure, numbers, ids and all that the suite itself has are checked; of
/// what libraries bring, the parameters are not.
/// @throws ConfigError
UncheckedExperiment readWithoutLibraries(const std::string& file, const std::vector<Override>& overrides = {});

}  // namespace swarmanoid
