/// The base class of rules that only measure: they do not change the run.
///
/// When    when the run begins, so that tick 0 has values, then after each tick whose number is a multiple of `every`.
///         In between, and at the end, metrics keep the values of the last measurement.
/// Who     the robots whose names begin with `robots`.
/// Errors  `read` refuses invalid parameters, `start` parameters that do not fit this world.
#pragma once

#include <cstdint>
#include <vector>

#include "common/parameters.hpp"
#include "robot_group.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::devices {

class MeasuringRule : public Rule {
 public:
  void configure(const Configuration& parameters) final {
    every_ = static_cast<std::uint64_t>(parameters.integer("every"));
    group_ = RobotGroup(parameters.text("robots"));
    read(parameters);
  }

  void reset(const Space& space, InterventionQueue&) final {
    group_.forget();
    start(space);
    look(space);
  }

  void afterTick(const Space& space, InterventionQueue&) final {
    if (space.tick % every_ == 0) {
      look(space);
    }
  }

  void archive(StateArchive& state) final {
    state(group_);
    archiveOwn(state);
  }

 protected:
  /// Parameters of such a rule: the common ones around its own.
  static std::vector<Parameter> withParameters(std::vector<Parameter> own) {
    own.insert(own.begin(), RobotGroup::parameter());
    own.push_back(makeParameter("every", Parameter::Type::kInteger, "ticks", "1", {1.0, 1e9},
                                "Ticks from one measurement to the next."));
    return own;
  }

  /// In `configure`: reads the rule's own parameters, and adds its metrics. @throws ConfigError
  virtual void read(const Configuration& parameters) = 0;
  /// Called when the run begins: resets the state of the rule. @throws ConfigError
  virtual void start(const Space&) {}
  /// Sets the metrics from the current state of the world.
  /// @param is_changed robots were added or deleted since the last measurement, or this is the first one with robots
  virtual void measure(const Space& space, bool is_changed) = 0;

  /// Rule::archive, without the group of robots.
  virtual void archiveOwn(StateArchive& state) = 0;

  /// The robots in this measurement.
  const RobotGroup& group() const { return group_; }
  /// Ticks from one measurement to the next.
  std::uint64_t every() const { return every_; }

 private:
  void look(const Space& space) {
    const bool is_changed = group_.look(space);
    measure(space, is_changed);
  }

  std::uint64_t every_ = 1;  // ticks
  RobotGroup group_;
};

}  // namespace swarmanoid::devices
