/// A recorded run as its folder holds it, read and checked, and what is needed to make it again.
///
/// Errors  ConfigError with file, line, what was found and what is allowed: a file that is missing or is not as it was
///         recorded, hashes that are cut off, a record of another format.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "swarmanoid_space/interventions/intervention_file.hpp"
#include "swarmanoid_space/records/run_record.hpp"

namespace swarmanoid {

struct RecordedHash {
  std::uint64_t tick = 0;  ///< finished ticks; 0: before the first one
  std::uint64_t hash = 0;
};

struct RecordedRun {
  std::string folder;
  RunRecord record;                  ///< without texts and contents, which are in the folder
  std::string interventions;         ///< text of a file of interventions, with its end
  std::vector<RecordedHash> hashes;  ///< from tick 0 on, RunRecord::every ticks apart; at least one
  std::string result;                ///< text of the summary; empty: the run was killed, or is not over
  std::vector<std::string> missing;  ///< what a run that was killed has not written, in sentences

  std::uint64_t ticks() const { return hashes.back().tick; }
  bool hasResult() const { return !result.empty(); }
};

/// @throws ConfigError
RecordedRun readRecordedRun(const std::string& folder);

/// The experiment of the record, with its name, seed and length. Loads the libraries that it names.
/// @throws ConfigError
Experiment experimentOf(const RecordedRun& run);

/// What was done to the run. @throws ConfigError
InterventionFile interventionsOf(const RecordedRun& run, const Experiment& experiment);

/// Those of them that are to be played: not what the rules of the experiment will ask for again.
InterventionFile withoutThoseOfRules(InterventionFile interventions, const Experiment& experiment);

/// The robots that other processes commanded at any time, by their names; none if no process could.
std::vector<std::string> robotsOfOthers(const RecordedRun& run, const Experiment& experiment,
                                        const InterventionFile& interventions);

}  // namespace swarmanoid
