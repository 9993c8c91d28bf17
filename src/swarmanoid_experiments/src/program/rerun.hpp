/// Repeats a recorded run: compares the state of each tick with the recorded one, and diverges from it at a fork if one
/// is requested.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_recording/records/recorded_run.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::program {

/// Changes relative to the recorded run from a tick on.
struct Fork {
  std::optional<std::uint64_t> seed;       ///< of random numbers
  std::optional<std::uint64_t> max_clock;  ///< [ticks], counted from the start of the run
  /// In order, each with its option, "--set arena.lamp.intensity".
  std::vector<std::pair<std::string, Intervention>> changes;

  bool isNone() const { return !seed && !max_clock && changes.empty(); }
};

/// @param settings "path=value", in the form of `--set` @throws ConfigError for a value that cannot change during a
/// run; the message lists those that can
Fork parseFork(const std::vector<std::string>& settings, std::optional<std::uint64_t> seed,
               const Experiment& experiment);

/// Applies the fork between two ticks. @throws ConfigError that names the option, for a rejected change
void part(Simulation& simulation, const Fork& fork);

/// @throws ConfigError if the result and the hashes of the record belong to different runs
void refuseOtherResult(const RecordedRun& run);

/// Outcome of a comparison.
struct Verdict {
  bool is_equal = true;
  bool is_interrupted = false;
  std::string text;  ///< for people
};

/// Starts the simulation, and runs its ticks up to `until`, or to the first one whose state differs from the recorded
/// one.
/// @param until finished ticks, at most run.ticks() @param after_tick is called after each tick; false: stop there
/// @throws exceptions of a tick, unless the recorded run ends at the same tick
Verdict compareTicks(Simulation& simulation, const RecordedRun& run, std::uint64_t until,
                     const std::function<bool()>& after_tick);

}  // namespace swarmanoid::program
