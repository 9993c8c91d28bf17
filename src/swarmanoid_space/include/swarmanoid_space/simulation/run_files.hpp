/// Files of a run beside those that its experiment file asks for: what options of the program and parameters of the
/// space's nodelet have in common.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "swarmanoid_space/output/out_folder.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

struct RunFiles {
  std::string prefix;                 ///< of the options, for messages: "--", "~"
  std::string folder;                 ///< made if it is not there; "": the current one
  OutFolder::Rules rules;             ///< for what is written in it
  bool records_bag = false;           ///< there is to be a bag: what writes it is loaded
  bool records_trajectories = false;  ///< likewise
  bool writes_frames = false;         ///< likewise
  std::vector<std::string> reads;     ///< files that the run reads beside those of the experiment; "" is none
};

/// The folder of a run's files, in which nothing that the run reads or needs is replaced. To be asked for when the
/// experiment has loaded its libraries.
/// @throws ConfigError if it cannot be made
std::shared_ptr<OutFolder> openOutFolder(const RunFiles& files, const Experiment& experiment);

/// Adds an observer that the experiment file does not have.
/// @param context of the run; its experiment is set
/// @param asked_by the option that asks for it, for messages: "--bag", "~record"
/// @param parameters named like the observer's label, which is registered
/// @throws ConfigError
void addObserver(Simulation& simulation, RunContext context, const std::string& asked_by, const std::string& id,
                 const Configuration& parameters);

}  // namespace swarmanoid
