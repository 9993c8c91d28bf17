/// Text of an experiment for records of runs. It contains the changes by overrides, and uses the record's names for
/// external files, so that the text has the same meaning wherever the record is read.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid::experiment {

/// Returns XML. Library files and library folders have absolute names.
/// @param new_names names of the files that the experiment was read from (Experiment::files), except the first one, the
/// experiment file itself
/// @throws ConfigError if the text does not name one of these files
std::string recordedText(const Experiment& experiment, const std::vector<std::string>& new_names);

}  // namespace swarmanoid::experiment
