/// Reads experiment files (docs/reference/experiment_file.md). Angles are in degrees in the file, in radians in the
/// result.
///
/// Phase    before a simulation is built from the result.
/// Threads  one at a time, because reading loads libraries. Warnings are kept for each thread.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {

/// Reads and checks an experiment file, and loads the libraries that it names.
/// @throws ConfigError for the first mistake: file, line, found text, allowed values, the nearest valid name
Experiment readExperiment(const std::string& file, const std::vector<Override>& overrides = {});

/// The same for a text; `name` replaces the file in messages.
Experiment parseExperiment(const std::string& text, const std::string& name,
                           const std::vector<Override>& overrides = {});

/// Loads the suite's own plugins (engines, devices, visualisations), once in a process. Thread-safe.
/// @throws ConfigError if a library cannot be loaded, or if no engine or no sensor is installed
void loadBuiltInPlugins();

/// Returns and clears the warnings of readExperiment, such as a controller_path that does not exist.
std::vector<std::string> takeExperimentWarnings();

namespace experiment {

/// Returns the text of a file. @throws ConfigError if it cannot be read, or is longer than limits::kLongestText
std::string textOf(const std::string& file);

}  // namespace experiment
}  // namespace swarmanoid
