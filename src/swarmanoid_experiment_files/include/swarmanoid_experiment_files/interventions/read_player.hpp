/// Reads files of interventions for playing them into a run.
///
/// Phase    before the first tick.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/interventions/intervention_file.hpp"
#include "swarmanoid_space/simulation/intervention_player.hpp"

namespace swarmanoid {

/// The player of a file for runs of the experiment. @param file "": none is played @param name of the file in messages
/// @param warn receives each warning of playingWarnings @throws ConfigError as readInterventions
InterventionPlayer readPlayer(const std::string& file, const std::string& name, AskedByRules asked_by_rules,
                              const Experiment& experiment, const std::function<void(const std::string&)>& warn);

/// Warnings about playing the file into a run of the experiment, in sentences: another experiment or seed, ticks that
/// do not occur, rules that are missing, or that will request interventions a second time.
std::vector<std::string> playingWarnings(const InterventionFile& file, AskedByRules asked_by_rules,
                                         const Experiment& experiment);

}  // namespace swarmanoid
