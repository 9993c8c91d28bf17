/// The text of an experiment for records of runs: what overrides have changed is in it, and what it names outside of
/// itself has the names that the record gives it, so that the text means the same wherever the record is read.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/experiment_file/experiment.hpp"

namespace swarmanoid::experiment {

/// XML. Libraries that are named by their files, and the folders of libraries, have absolute names.
/// @param new_names of the files that the experiment was read from (Experiment::files), without the first one, which is
/// the experiment file itself @throws ConfigError if the text does not name one of these files
std::string recordedText(const Experiment& experiment, const std::vector<std::string>& new_names);

}  // namespace swarmanoid::experiment
