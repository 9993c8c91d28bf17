/// Where rules ask for interventions.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

/// The answer to a request for an intervention. It is written once, on the simulation's thread, and read from any.
class InterventionAnswer {
 public:
  enum class State { kPending, kDone, kRefused };

  State state() const { return state_.load(std::memory_order_acquire); }
  /// The reason of the refusal; "" unless it was refused.
  std::string refusal() const { return state() == State::kRefused ? refusal_ : ""; }

  // For the simulation.
  void setDone() { state_.store(State::kDone, std::memory_order_release); }
  void setRefused(const std::string& reason) {
    refusal_ = reason;
    state_.store(State::kRefused, std::memory_order_release);
  }

 private:
  std::atomic<State> state_{State::kPending};
  std::string refusal_;
};

/// An intervention that has been asked for.
struct AskedIntervention {
  Intervention what;
  std::string asked_by;  ///< "rule 'foraging'"
  bool may_be_refused = false;
  std::shared_ptr<InterventionAnswer> answer;  ///< null: no answer is wanted
};

/// Interventions that have been asked for, and are carried out in that order before the next tick.
class InterventionQueue {
 public:
  /// Asks for what must work: if it is refused, the run ends with the reason.
  /// @param answer gets what came of it, once that is known; of a run that is reset before it stays pending
  void ask(Intervention intervention, std::shared_ptr<InterventionAnswer> answer = nullptr) {
    asked_.push_back({std::move(intervention), asking_, false, std::move(answer)});
  }
  /// Asks for what may be refused: then an event of the next tick says why, and the run goes on. @param answer as above
  void tryTo(Intervention intervention, std::shared_ptr<InterventionAnswer> answer = nullptr) {
    asked_.push_back({std::move(intervention), asking_, true, std::move(answer)});
  }

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
