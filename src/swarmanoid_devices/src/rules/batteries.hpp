// Batteries of the robots that a rule charges, and their metrics.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/rule.hpp"
#include "update_members.hpp"

namespace swarmanoid::devices {

class Batteries {
 public:
  struct Robot {
    EntityNumber number = kNoEntity;
    double used = 0.0;      // J, at the last measurement
    bool is_empty = false;  // at the last measurement
  };

  /// @param robot prefix of the robots' names @param add adds a metric to the rule
  template <class AddMetric>
  void configure(const std::string& robot, AddMetric add) {
    robot_ = robot;
    mean_level_ = &add("mean_level", "J", "Charge of a robot's battery, in the mean over the robots.");
    empty_ = &add("empty", "", "Robots that are empty now, and wait for charge.");
    ran_empty_ = &add("ran_empty", "", "How often a robot ran empty.");
    drained_ = &add("drained", "J", "Energy that robots have used.");
  }

  void clear() { robots_.clear(); }
  /// For snapshots.
  void archive(StateArchive& state) { state(robots_); }

  /// Removes deleted robots and adds new ones with a battery.
  void updateMembers(const Space& space) {
    const auto is_meant = [&](Row row) { return space.entities.name[row].compare(0, robot_.size(), robot_) == 0; };
    swarmanoid::devices::updateMembers(space, space.powered, is_meant, robots_);
  }

  /// By entity number.
  const std::vector<Robot>& all() const { return robots_; }

  /// Called after each tick. @pre all robots of the list exist: updateMembers was called after the last deletion
  void measure(const Space& space) {
    double sum = 0.0;
    double empty = 0.0;
    for (Robot& robot : robots_) {
      const Row row = space.entities.find(robot.number);
      const BatteryState& state = space.batteries[row][0];
      sum += space.properties[row][kBatteryCharge];
      empty += state.is_empty ? 1.0 : 0.0;
      drained_->value += state.used - robot.used;
      ran_empty_->value += state.is_empty && !robot.is_empty ? 1.0 : 0.0;
      robot.used = state.used;
      robot.is_empty = state.is_empty;
    }
    mean_level_->value = robots_.empty() ? 0.0 : sum / static_cast<double>(robots_.size());
    empty_->value = empty;
  }

 private:
  std::string robot_;
  std::vector<Robot> robots_;
  Metric* mean_level_ = nullptr;
  Metric* empty_ = nullptr;
  Metric* ran_empty_ = nullptr;
  Metric* drained_ = nullptr;
};

}  // namespace swarmanoid::devices
