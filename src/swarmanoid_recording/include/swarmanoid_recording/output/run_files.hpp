/// Files of a run in addition to those of its experiment file: the common part of the program's options and the
/// parameters of the space nodelet.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_recording/output/out_folder.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

struct RunFiles {
  std::string prefix;                 ///< of the options, for messages: "--", "~"
  std::string folder;                 ///< created if missing; "": the current one
  OutFolder::Rules rules;             ///< for files written in it
  bool records_bag = false;           ///< a bag is recorded: loads the plugin for it
  bool records_trajectories = false;  ///< trajectories are recorded: loads the plugin for them
  bool writes_frames = false;         ///< frames are written: loads the plugin for them
  std::vector<std::string> reads;  ///< files that the run reads in addition to those of the experiment; "" is skipped
};

/// Loads the suite's library with that visualisation. @throws ConfigError if it is not installed
void loadVisualisation(const std::string& label);

/// The folder of a run's files; protects all files that the run reads or needs. Call it after the experiment has loaded
/// its libraries.
/// @throws ConfigError if it cannot be made
std::shared_ptr<OutFolder> openOutFolder(const RunFiles& files, const Experiment& experiment);

/// Adds an observer that is not in the experiment file.
/// @param context of the run; its experiment is set
/// @param asked_by the option that requests it, for messages: "--bag", "~record"
/// @param parameters named like the observer's label, which must be registered
/// @throws ConfigError
void addObserver(Simulation& simulation, RunContext context, const std::string& asked_by, const std::string& id,
                 const Configuration& parameters);

}  // namespace swarmanoid
