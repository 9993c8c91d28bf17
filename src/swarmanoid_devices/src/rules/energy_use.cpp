// Energy: consumption of robots by the battery model, with or without a battery.
#include <vector>

#include "measuring_rule.hpp"
#include "swarmanoid_space/power_demand.hpp"
#include "update_members.hpp"

namespace swarmanoid::devices {
namespace {

class EnergyUse final : public MeasuringRule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "energy_use";
    description.summary = "Measures the energy that robots use, with or without batteries.";
    description.parameters = withParameters({});
    return description;
  }

 private:
  struct Robot {
    EntityNumber number = kNoEntity;
    double used = 0.0;  // J, energy used from its battery until the last measurement
    Eigen::Vector2d position = Eigen::Vector2d::Zero();
    bool is_known = false;
  };

  void read(const Configuration&) override {
    used_ = &addMetric("used", "J", "Energy that robots have used.");
    power_ = &addMetric("power", "W", "Total power that robots draw.");
    per_metre_ = &addMetric("per_metre", "J/m", "Energy used per distance travelled; 0 without motion.");
  }

  void archiveOwn(StateArchive& state) override {
    state(robots_, way_, has_begun_);
    if (state.isLoading()) {
      model_ = nullptr;  // it may be of another world
    }
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
      updateMembers(space, group().rows(), is_meant, robots_);
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

  /// Adds the consumption of a robot since the last measurement. @return its power [W]
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

  /// Standby power [W]; cached, since most robots have the model and controller of the previous one.
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

  std::vector<Robot> robots_;  // by entity number, in the order of the group
  double way_ = 0.0;           // m, path length of all robots
  bool has_begun_ = false;
  const EntityModel* model_ = nullptr;                 // key of standby_
  const ControllerDescription* controller_ = nullptr;  // key of standby_
  double standby_ = 0.0;                               // W, cached standby power
  Metric* used_ = nullptr;
  Metric* power_ = nullptr;
  Metric* per_metre_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::EnergyUse)
