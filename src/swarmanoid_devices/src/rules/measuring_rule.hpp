/// The base class of rules that only measure: they ask for nothing, so a run is the same with them and without.
///
/// When    as the run begins, so that tick 0 has values, then after each tick whose number is a multiple of `every`.
///         In between, and at the end, metrics keep the values of the last such tick.
/// Who     the robots whose names begin as `robots` says.
/// Errors  `read` refuses what is wrong in itself, `start` what is wrong with this world.
#pragma once

#include <cstdint>
#include <vector>

#include "../parameters.hpp"
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

 protected:
  /// The table of such a rule: what all of them have, around its own.
  static std::vector<Parameter> withParameters(std::vector<Parameter> own) {
    own.insert(own.begin(), RobotGroup::parameter());
    own.push_back(makeParameter("every", Parameter::Type::kInteger, "ticks", "1", {1.0, 1e9},
                                "Ticks from one measurement to the next."));
    return own;
  }

  /// In `configure`: values of its own, and metrics. @throws ConfigError
  virtual void read(const Configuration& parameters) = 0;
  /// The run begins: all that the rule keeps starts anew. @throws ConfigError
  virtual void start(const Space&) {}
  /// Sets the metrics, as the world is now.
  /// @param is_changed other robots are there than at the last measurement, or it is the first one with robots
  virtual void measure(const Space& space, bool is_changed) = 0;

  /// As they are in this measurement.
  const RobotGroup& group() const { return group_; }
  /// From one measurement to the next.
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
