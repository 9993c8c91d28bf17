/// Plays recorded interventions into a run, each in its tick.
///
/// Rules   interventions that rules requested are omitted by default, since the same rules request them again in the
///         new run; a run without these rules needs them played.
/// Bits    a run with the same experiment and seed, and without other interventions from outside, has the state hashes
///         of the recorded one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "swarmanoid_space/interventions/intervention_file.hpp"

namespace swarmanoid {

/// Treatment of interventions that rules requested.
enum class AskedByRules { kLeftOut, kPlayed };

class InterventionPlayer {
 public:
  /// A player without interventions.
  InterventionPlayer() = default;
  InterventionPlayer(InterventionFile file, AskedByRules asked_by_rules);

  /// Takes the next intervention if it is due. Does not allocate.
  /// @param tick, after_rules of the run, as in TakenIntervention
  /// @return null: none is due
  const RecordedIntervention* takeDue(std::uint64_t tick, bool after_rules);
  /// Called when a new run begins.
  void restart() { next_ = 0; }
  std::size_t left() const { return interventions_.size() - next_; }

 private:
  std::vector<RecordedIntervention> interventions_;
  std::size_t next_ = 0;
};

/// The player of a file for runs of the experiment. @param file "": none is played @param name of the file in messages
/// @param warn receives each warning of playingWarnings @throws ConfigError as readInterventions
InterventionPlayer readPlayer(const std::string& file, const std::string& name, AskedByRules asked_by_rules,
                              const Experiment& experiment, const std::function<void(const std::string&)>& warn);

/// Warnings about playing the file into a run of the experiment, in sentences: another experiment or seed, ticks that
/// do not occur, rules that are missing, or that will request interventions a second time.
std::vector<std::string> playingWarnings(const InterventionFile& file, AskedByRules asked_by_rules,
                                         const Experiment& experiment);

}  // namespace swarmanoid
