/// Where rules ask for interventions.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

/// An intervention that has been asked for.
struct AskedIntervention {
  Intervention what;
  std::string asked_by;  ///< "rule 'foraging'"
  bool may_be_refused = false;
};

/// Interventions that have been asked for, and are carried out in that order before the next tick.
class InterventionQueue {
 public:
  /// Asks for what must work: if it is refused, the run ends with the reason.
  void ask(Intervention intervention) { asked_.push_back({std::move(intervention), asking_, false}); }
  /// Asks for what may be refused: then an event of the next tick says why, and the run goes on.
  void tryTo(Intervention intervention) { asked_.push_back({std::move(intervention), asking_, true}); }

  /// Who asks from now on. For whoever calls rules.
  void setAsking(const std::string& who) { asking_ = who; }
  bool isEmpty() const { return asked_.empty(); }
  /// All that was asked for; the queue is empty then, and keeps its memory.
  void takeInto(std::vector<AskedIntervention>& asked) {
    asked.clear();
    asked.swap(asked_);
  }
  void clear() { asked_.clear(); }

 private:
  std::string asking_;
  std::vector<AskedIntervention> asked_;
};

}  // namespace swarmanoid
