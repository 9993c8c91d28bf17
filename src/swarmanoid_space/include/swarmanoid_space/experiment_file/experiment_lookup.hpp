/// From what a user types to an experiment file.
#pragma once

#include <string>
#include <vector>

namespace swarmanoid {

/// The file itself if it exists, else the installed experiment of that name ("object_retrieval").
/// @throws ConfigError naming the installed ones
std::string findExperiment(const std::string& file_or_name);

/// Names of the installed experiments, sorted.
std::vector<std::string> installedExperiments();

}  // namespace swarmanoid
