// Taxis: progress of a group of robots towards a target, to judge swarms that move as a whole. The rule only measures.
#include <optional>
#include <string>

#include "common/parameters.hpp"
#include "named_entity.hpp"
#include "robot_group.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::devices {
namespace {

class Taxis final : public Rule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "taxis";
    description.summary = "Measures how far robots, as one, have come towards something.";
    description.parameters = {makeParameter("target", Parameter::Type::kText, "", std::nullopt, {},
                                            "Id of the entity towards which they are to come."),
                              RobotGroup::parameter()};
    return description;
  }

  void configure(const Configuration& parameters) override {
    target_ = parameters.text("target");
    group_ = RobotGroup(parameters.text("robots"));
    location_ = parameters.location();
    distance_ = &addMetric("distance", "m", "From the robots' centroid to the target, seen from above.");
    progress_ = &addMetric("progress", "m", "By which that distance is less than when the run began.");
  }

  void reset(const Space& space, InterventionQueue&) override {
    const Row target = requireEntity(space, "target", target_, location_);
    group_.forget();
    measure(space, target);
  }

  void afterTick(const Space& space, InterventionQueue&) override {
    const Row target = space.entities.find(target_);
    if (target != kNoRow) {
      measure(space, target);
    }
  }

  void archive(StateArchive& state) override { state(group_, distance_at_first_); }

 private:
  /// Without robots the metrics keep their values.
  void measure(const Space& space, Row target) {
    const bool is_changed = group_.look(space);
    const std::optional<Eigen::Vector2d> centroid = group_.centroid(space);
    if (!centroid) {
      return;
    }
    distance_->value = (*centroid - space.entities.pose[target].position.head<2>()).norm();
    if (is_changed) {  // also for the first robots of a run, whose progress is 0
      distance_at_first_ = distance_->value + progress_->value;
    } else {
      progress_->value = distance_at_first_ - distance_->value;
    }
  }

  std::string target_;
  RobotGroup group_;
  SourceLocation location_;
  double distance_at_first_ = 0.0;  // m: initial distance that gives the same progress with the current robots
  Metric* distance_ = nullptr;
  Metric* progress_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::Taxis)
