// Energy: what robots use, by the law of batteries, whether they run on one or not.
#include <vector>

#include "enlist.hpp"
#include "measuring_rule.hpp"
#include "swarmanoid_space/power_demand.hpp"

namespace swarmanoid::devices {
namespace {

class EnergyUse final : public MeasuringRule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "energy_use";
    description.summary = "Measures what energy robots use, on batteries or not.";
    description.parameters = withParameters({});
    return description;
  }

 private:
  struct Robot {
    EntityNumber number = kNoEntity;
    double used = 0.0;  // J, of its battery, at the last measurement
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    bool is_known = false;
  };

  void read(const Configuration&) override {
    used_ = &addMetric("used", "J", "What robots have used.");
    power_ = &addMetric("power", "W", "What robots draw, all together.");
    per_metre_ = &addMetric("per_metre", "J/m", "What they have used by the length of their ways; 0 without any.");
  }

  void start(const Space&) override {
    robots_.clear();
    way_ = 0.0;
    has_begun_ = false;
    model_ = nullptr;
  }

  void measure(const Space& space, bool is_changed) override {
    if (is_changed) {
      const auto is_meant = [](Row) { return true; };
      enlist(space, group().rows(), is_meant, robots_);
    }
    const double time = has_begun_ ? static_cast<double>(every()) * toSeconds(space.clocktick) : 0.0;
    has_begun_ = true;
    double power = 0.0;
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      power += account(space, group().rows()[i], time, robots_[i]);
    }
    power_->value = power;
    per_metre_->value = way_ > 0.0 ? used_->value / way_ : 0.0;
  }

  /// @return what the robot draws [W]
  double account(const Space& space, Row row, double time, Robot& robot) {
    const Eigen::Vector2d position = space.entities.pose[row].position.head<2>();
    if (robot.is_known) {
      way_ += (position - robot.position).norm();
    }
    robot.position = position;
    robot.is_known = true;
    const EntityModel& model = *space.entities.model[row];
    if (model.battery) {
      const BatteryState& state = space.batteries[row][0];
      used_->value += state.used - robot.used;
      robot.used = state.used;
      return state.power;
    }
    if (!model.possible_battery) {
      return 0.0;
    }
    const double power = powerDemand(space, row, *model.possible_battery, standbyOf(space, row));
    used_->value += power * time;
    return power;
  }

  /// Most robots are as the one before them: then it is known.
  double standbyOf(const Space& space, Row row) {
    const EntityModel* model = space.entities.model[row].get();
    const ControllerDescription* controller = space.controllers[row].description;
    if (model != model_ || controller != controller_) {
      model_ = model;
      controller_ = controller;
      standby_ = standbyPower(*model->possible_battery, controller);
    }
    return standby_;
  }

  std::vector<Robot> robots_;  // by entity number, as the group has them
  double way_ = 0.0;           // m, of all robots
  bool has_begun_ = false;
  const EntityModel* model_ = nullptr;                 // of the last robot that was asked for its standby, with
  const ControllerDescription* controller_ = nullptr;  // its controller,
  double standby_ = 0.0;                               // W, and what it is
  Metric* used_ = nullptr;
  Metric* power_ = nullptr;
  Metric* per_metre_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::EnergyUse)
