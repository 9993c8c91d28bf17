/// The queue in which rules request interventions.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "swarmanoid_space/intervention.hpp"

namespace swarmanoid {

/// The answer to a request for an intervention. It is written once, on the simulation's thread, and may be read on any.
class InterventionAnswer {
 public:
  enum class State { kPending, kDone, kRefused };

  State state() const { return state_.load(std::memory_order_acquire); }
  /// The reason of the refusal; "" in other states.
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

/// An intervention that has been requested.
struct AskedIntervention {
  Intervention what;
  std::string asked_by;  ///< "rule 'foraging'"
  bool may_be_refused = false;
  std::shared_ptr<InterventionAnswer> answer;  ///< null: no answer wanted
};

/// Requested interventions; they are carried out in order before the next tick.
class InterventionQueue {
 public:
  /// Requests an intervention that must succeed: a refusal ends the run with the reason.
  /// @param answer receives the outcome; stays pending if the run is reset before
  void ask(Intervention intervention, std::shared_ptr<InterventionAnswer> answer = nullptr) {
    asked_.push_back({std::move(intervention), asking_, false, std::move(answer)});
  }
  /// Requests an intervention that may be refused: a refusal becomes an event of the next tick, and the run goes on.
  /// @param answer as above
  void tryTo(Intervention intervention, std::shared_ptr<InterventionAnswer> answer = nullptr) {
    asked_.push_back({std::move(intervention), asking_, true, std::move(answer)});
  }

  /// Sets the author of the following requests. For the code that calls rules.
  void setAsking(const std::string& who) { asking_ = who; }
  bool isEmpty() const { return asked_.empty(); }
  /// Moves all requests to `asked`. The queue is empty afterwards and keeps its memory.
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
