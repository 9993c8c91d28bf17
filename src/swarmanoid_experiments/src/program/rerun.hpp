/// Makes a recorded run again: compares the state of each tick with the recorded one, and parts from it where a fork is
/// asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_space/records/recorded_run.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::program {

/// What is other than in the recorded run from a tick on.
struct Fork {
  std::optional<std::uint64_t> seed;       ///< that random numbers are drawn with
  std::optional<std::uint64_t> max_clock;  ///< [ticks] counted from the beginning of the run
  /// In their order, each with the option that asks for it, "--set arena.lamp.intensity".
  std::vector<std::pair<std::string, Intervention>> changes;

  bool isNone() const { return !seed && !max_clock && changes.empty(); }
};

/// @param settings "path=value", as `--set` has them @throws ConfigError for what cannot change in the middle of a run,
/// with what can
Fork parseFork(const std::vector<std::string>& settings, std::optional<std::uint64_t> seed,
               const Experiment& experiment);

/// Parts from the recorded run, between two ticks. @throws ConfigError that names the option for a change that is
/// refused
void part(Simulation& simulation, const Fork& fork);

/// @throws ConfigError if the result of the record is of another run than its hashes
void refuseOtherResult(const RecordedRun& run);

/// What came of a comparison.
struct Verdict {
  bool is_equal = true;
  bool is_interrupted = false;
  std::string text;  ///< for people
};

/// Starts the simulation, and makes its ticks up to `until`, or to the first one whose state is not the recorded one.
/// @param until finished ticks, at most run.ticks() @param after_tick is called after each tick; false: it ends there
/// @throws what a tick throws, unless the recorded run ends there too
Verdict compareTicks(Simulation& simulation, const RecordedRun& run, std::uint64_t until,
                     const std::function<bool()>& after_tick);

}  // namespace swarmanoid::program
