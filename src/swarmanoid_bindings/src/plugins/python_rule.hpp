/// A rule in Python: an object with any of the functions of a C++ rule (swarmanoid_space/rule.hpp):
/// init(parameters), reset(world), before_tick(world), after_tick(world), finished(), success(), metrics().
///
/// Phases   as of a rule. finished, success and metrics are called after reset and after_tick, and their results hold
///          until the next such call; metrics is also called once after init, to get the names of the metrics.
/// Threads  acquires the GIL for each call.
/// Errors   a Python exception ends the run as RuleError, with the exception as its cause; Ctrl-C ends only the ticks.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <vector>

#include "moment.hpp"
#include "python/holds_objects.hpp"
#include "python/thrown.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::bindings {

class PythonRule final : public Rule, public HoldsObjects {
 public:
  /// @throws pybind11::type_error if the object has none of the functions
  PythonRule(pybind11::object rule, std::shared_ptr<Moment> moment, std::shared_ptr<Thrown> thrown);

  void configure(const Configuration& parameters) override;
  void reset(const Space& space, InterventionQueue& queue) override;
  void beforeTick(const Space& space, InterventionQueue& queue) override;
  void afterTick(const Space& space, InterventionQueue& queue) override;
  void archive(StateArchive& state) override;
  bool isFinished() const override { return is_finished_; }
  std::optional<bool> success() const override { return success_; }

  int visitObjects(visitproc visit, void* argument) const override { return visitEach(visit, argument, rule_); }
  void releaseObjects() override { rule_ = {}; }

 private:
  template <class Action>
  void call(const char* hook, Action action);
  void callWith(const char* hook, const Space& space, InterventionQueue& queue);
  void judge();
  void takeMetrics();

  pybind11::object rule_;
  std::shared_ptr<Moment> moment_;
  std::shared_ptr<Thrown> thrown_;
  std::vector<Metric*> own_metrics_;
  bool is_finished_ = false;
  std::optional<bool> success_;
};

}  // namespace swarmanoid::bindings
