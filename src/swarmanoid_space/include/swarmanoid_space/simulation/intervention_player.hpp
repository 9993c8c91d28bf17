/// Plays recorded interventions into a run, in their ticks.
///
/// Rules   what the rules of the recorded run asked for is left out as a rule, since the same rules ask for it again in
///         the run that it is played into; a run without them needs it played.
/// Bits    a run with the same experiment and seed, in which nothing else is done from outside, has the state hashes of
///         the recorded one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "swarmanoid_space/interventions/intervention_file.hpp"

namespace swarmanoid {

/// Of those that rules asked for.
enum class AskedByRules { kLeftOut, kPlayed };

class InterventionPlayer {
 public:
  /// Of none.
  InterventionPlayer() = default;
  InterventionPlayer(InterventionFile file, AskedByRules asked_by_rules);

  /// The next one if it is due, and then it is no more. Allocates nothing.
  /// @param tick, after_rules where the run is, as TakenIntervention has them
  /// @return null: none is due
  const RecordedIntervention* takeDue(std::uint64_t tick, bool after_rules);
  /// A new run begins.
  void restart() { next_ = 0; }
  std::size_t left() const { return interventions_.size() - next_; }

 private:
  std::vector<RecordedIntervention> interventions_;
  std::size_t next_ = 0;
};

/// The player of a file for runs of the experiment. @param file "": none is played @param name of it in messages
/// @param warn gets what is strange about it, each by itself @throws ConfigError as readInterventions
InterventionPlayer readPlayer(const std::string& file, const std::string& name, AskedByRules asked_by_rules,
                              const Experiment& experiment, const std::function<void(const std::string&)>& warn);

/// What is strange about playing the file into a run of the experiment, in sentences: another experiment or seed, ticks
/// that do not come, rules that are not there to ask, or are there to ask a second time.
std::vector<std::string> playingWarnings(const InterventionFile& file, AskedByRules asked_by_rules,
                                         const Experiment& experiment);

}  // namespace swarmanoid
