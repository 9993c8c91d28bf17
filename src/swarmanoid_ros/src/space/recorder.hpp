/// Determines the files that a run may write under ROS, and adds those that parameters of the space request to those of
/// the experiment file. They are written in process and attached before the first tick, so no tick is missing.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "space_options.hpp"
#include "swarmanoid_recording/output/out_folder.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

/// Opens the folder that the options name, and loads the libraries that are needed to write.
/// @throws ConfigError
std::shared_ptr<OutFolder> openOutFolder(const SpaceOptions& options, const Experiment& experiment);

/// Adds recorders for the bag, the state hashes and the interventions that the options request, relative to the out
/// folder of the run.
/// @param space name of the space's node, for topics
/// @return descriptions of the written files, for the log @throws ConfigError
std::vector<std::string> addRecorders(Simulation& simulation, const RunContext& context, const SpaceOptions& options,
                                      const std::string& space);

}  // namespace swarmanoid
