/// Files of a run under ROS: which may be written, and those that parameters of the space ask for, beside those of the
/// experiment file. Written in process and attached before the first tick, so no tick is missing.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "space_options.hpp"
#include "swarmanoid_space/output/out_folder.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

/// The folder that the options name, with the libraries loaded that the run needs to write.
/// @throws ConfigError
std::shared_ptr<OutFolder> openOutFolder(const SpaceOptions& options, const Experiment& experiment);

/// Records the bag and writes the state hashes that the options ask for, relative to the out folder of the run.
/// @param space name of the space's node, for topics
/// @return what is written where, for the log @throws ConfigError
std::vector<std::string> addRecorders(Simulation& simulation, const RunContext& context, const SpaceOptions& options,
                                      const std::string& space);

}  // namespace swarmanoid
