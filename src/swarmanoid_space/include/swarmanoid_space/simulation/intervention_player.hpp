/// Plays recorded interventions into a run, each in its tick.
///
/// Rules   interventions that rules requested are omitted by default, since the same rules request them again in the
///         new run; a run without these rules needs them played.
/// Bits    a run with the same experiment and seed, and without other interventions from outside, has the state hashes
///         of the recorded one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

/// Treatment of interventions that rules requested.
enum class AskedByRules { kLeftOut, kPlayed };

class InterventionPlayer {
 public:
  /// A player without interventions.
  InterventionPlayer() = default;
  InterventionPlayer(std::vector<RecordedIntervention> interventions, AskedByRules asked_by_rules);

  /// Takes the next intervention if it is due. Does not allocate.
  /// @param tick, after_rules of the run, as in TakenIntervention
  /// @return null: none is due
  const RecordedIntervention* takeDue(std::uint64_t tick, bool after_rules);
  /// Called when a new run begins.
  void restart() { next_ = 0; }
  /// Its position among the interventions, for snapshots; a player with fewer of them has none left. @{
  std::size_t position() const { return next_; }
  void goTo(std::size_t position) { next_ = position < interventions_.size() ? position : interventions_.size(); }
  /// @}
  std::size_t left() const { return interventions_.size() - next_; }

 private:
  std::vector<RecordedIntervention> interventions_;
  std::size_t next_ = 0;
};

}  // namespace swarmanoid
