/// Finds the experiment file that a user asks for.
#pragma once

#include <string>
#include <vector>

namespace swarmanoid {

/// The file itself if it exists, else the installed experiment of that name ("object_retrieval").
/// @throws ConfigError; the message lists the installed experiments
std::string findExperiment(const std::string& file_or_name);

/// Names of the installed experiments, sorted.
std::vector<std::string> installedExperiments();

}  // namespace swarmanoid
