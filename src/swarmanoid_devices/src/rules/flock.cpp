// A flock: how well the headings of robots agree, and whether robots stay together, to judge controllers that align
// with the headings of others.
#include <algorithm>
#include <cmath>
#include <optional>

#include "common/parameters.hpp"
#include "robot_group.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::devices {
namespace {

class Flock final : public Rule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "flock";
    description.summary = "Measures how well robots drive in one direction, and how close together they are.";
    description.parameters = {RobotGroup::parameter(),
                              number("settling", "s", "0", {0.0, 1e9}, "Time of the run after which means are taken.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    group_ = RobotGroup(parameters.text("robots"));
    settling_ = parameters.number("settling");
    order_ = &addMetric("order", "", "Length of the mean of the robots' headings as vectors: 1 if all are the same.");
    mean_order_ = &addMetric("mean_order", "", "Its mean over the ticks that count.");
    spread_ = &addMetric("spread", "m", "Mean distance of the robots from their centre, seen from above.");
    speed_ = &addMetric("speed", "m/s", "How fast the centre moves, in the mean over the ticks that count.");
  }

  void reset(const Space&, InterventionQueue&) override { ticks_ = 0; }

  void afterTick(const Space& space, InterventionQueue&) override {
    const bool is_changed = group_.look(space);
    const std::optional<Eigen::Vector2d> centre = group_.centroid(space);
    measure(space, centre);
    if (centre && toSeconds(space.time - kEpoch) >= settling_) {
      ++ticks_;
      mean_order_->value += (order_->value - mean_order_->value) / static_cast<double>(ticks_);
      follow(space, *centre, is_changed);
    }
  }

  void archive(StateArchive& state) override { state(group_, ticks_, first_, first_centre_, last_, last_centre_); }

 private:
  /// Sets order and spread; 0 without robots.
  void measure(const Space& space, const std::optional<Eigen::Vector2d>& centre) {
    Eigen::Vector2d headings = Eigen::Vector2d::Zero();
    double distances = 0.0;
    for (const Row row : group_.rows()) {
      const Pose& pose = space.entities.pose[row];
      headings += (pose.orientation * Eigen::Vector3d::UnitX()).head<2>().stableNormalized();
      distances += (pose.position.head<2>() - *centre).norm();
    }
    const double share = centre ? 1.0 / static_cast<double>(group_.rows().size()) : 0.0;
    order_->value = share * headings.norm();
    spread_->value = share * distances;
  }

  /// Updates the speed of the centre, in a tick that counts.
  void follow(const Space& space, const Eigen::Vector2d& centre, bool is_changed) {
    if (ticks_ == 1) {
      first_ = space.time;
      first_centre_ = centre;
    } else if (is_changed) {  // arrivals and departures shift the centre: skip the shift and its tick
      first_ += space.time - last_;
      first_centre_ += centre - last_centre_;
    } else {
      speed_->value = (centre - first_centre_).norm() / toSeconds(space.time - first_);
    }
    last_ = space.time;
    last_centre_ = centre;
  }

  RobotGroup group_;
  double settling_ = 0.0;                                   // s
  std::uint64_t ticks_ = 0;                                 // number of ticks that count so far
  Time first_ = kEpoch;                                     // time of the first of them
  Eigen::Vector2d first_centre_ = Eigen::Vector2d::Zero();  // m: centre at that time, corrected for shifts
  Time last_ = kEpoch;                                      // time of the last of them
  Eigen::Vector2d last_centre_ = Eigen::Vector2d::Zero();   // m: centre at that time
  Metric* order_ = nullptr;
  Metric* mean_order_ = nullptr;
  Metric* spread_ = nullptr;
  Metric* speed_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::Flock)
