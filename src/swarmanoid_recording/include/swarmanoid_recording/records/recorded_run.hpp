/// A recorded run, read from its folder and checked, and the data needed to repeat it.
///
/// Errors  ConfigError with file, line, found text and allowed values: a file that is missing or differs from the
///         recorded one, truncated hashes, a record of another format.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "swarmanoid_experiment_files/interventions/intervention_file.hpp"
#include "swarmanoid_recording/records/run_record.hpp"

namespace swarmanoid {

struct RecordedHash {
  std::uint64_t tick = 0;  ///< finished ticks; 0: before the first one
  std::uint64_t hash = 0;
};

struct RecordedRun {
  std::string folder;
  RunRecord record;                  ///< without texts and contents, which are in the folder
  std::string interventions;         ///< text of an intervention file, with its end
  std::vector<RecordedHash> hashes;  ///< from tick 0 on, RunRecord::every ticks apart; at least one
  std::string result;                ///< text of the summary; empty: the run was killed, or is not over
  std::vector<std::string> missing;  ///< sentences about the data that a killed run has not written

  std::uint64_t ticks() const { return hashes.back().tick; }
  bool hasResult() const { return !result.empty(); }
};

/// @throws ConfigError
RecordedRun readRecordedRun(const std::string& folder);

/// The experiment of the record, with its name, seed and length. Loads the libraries that it names.
/// @throws ConfigError
Experiment experimentOf(const RecordedRun& run);

/// The interventions of the recorded run. @throws ConfigError
InterventionFile interventionsOf(const RecordedRun& run, const Experiment& experiment);

/// The interventions to be played: those that the rules of the experiment will request again are omitted.
InterventionFile withoutThoseOfRules(InterventionFile interventions, const Experiment& experiment);

/// Names of the robots that other processes commanded at any time; empty if no process could.
std::vector<std::string> robotsOfOthers(const RecordedRun& run, const Experiment& experiment,
                                        const InterventionFile& interventions);

}  // namespace swarmanoid
