#include "swarmanoid_space/simulation/intervention_player.hpp"

#include <algorithm>
#include <utility>

namespace swarmanoid {

InterventionPlayer::InterventionPlayer(std::vector<RecordedIntervention> interventions, AskedByRules asked_by_rules)
    : interventions_(std::move(interventions)) {
  if (asked_by_rules == AskedByRules::kLeftOut) {
    interventions_.erase(std::remove_if(interventions_.begin(), interventions_.end(),
                                        [](const auto& recorded) { return !recorded.taken.asked_by.empty(); }),
                         interventions_.end());
  }
}

const RecordedIntervention* InterventionPlayer::takeDue(std::uint64_t tick, bool after_rules) {
  if (next_ == interventions_.size()) {
    return nullptr;
  }
  const TakenIntervention& taken = interventions_[next_].taken;
  const bool is_due = taken.tick < tick || (taken.tick == tick && (after_rules || !taken.after_rules));
  return is_due ? &interventions_[next_++] : nullptr;
}

}  // namespace swarmanoid
