// Contacts: how many robots touch each other and arena objects; how often, and for how long. Contacts follow from the
// poses of bodies, independent of the engines that move them.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "footprint.hpp"
#include "measuring_rule.hpp"
#include "swarmanoid_space/index/positional_index_visits.hpp"
#include "update_members.hpp"

namespace swarmanoid::devices {
namespace {

class ContactCount final : public MeasuringRule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "contact_count";
    description.summary = "Counts contacts of robots with each other and with objects.";
    description.parameters =
        withParameters({number("gap", "m", "0.001", {0.0, 1.0}, "Between bodies, up to which they touch.")});
    return description;
  }

 private:
  struct Robot {
    EntityNumber number = kNoEntity;
    bool is_touching = false;
    bool was_touching = false;  // in the last measurement
  };

  void read(const Configuration& parameters) override {
    gap_ = parameters.number("gap");
    robot_pairs_ = &addMetric("robot_pairs", "", "Pairs of robots in contact.");
    object_pairs_ = &addMetric("object_pairs", "", "Pairs of a robot and an object in contact.");
    touching_ = &addMetric("touching", "", "Robots that touch a robot or an object.");
    collisions_ = &addMetric("collisions", "", "How often a robot without contact came into contact.");
    time_ = &addMetric("time", "s", "Time in contact, in the mean over the robots.");
  }

  void archiveOwn(StateArchive& state) override {
    state(robots_, has_begun_);
    if (state.isLoading()) {
      population_ = {};
    }
  }

  void start(const Space&) override {
    robots_.clear();
    population_ = {};
    has_begun_ = false;
  }

  void measure(const Space& space, bool is_changed) override {
    if (is_changed) {
      const auto is_meant = [](Row) { return true; };
      updateMembers(space, group().rows(), is_meant, robots_);
    }
    if (population_.hasChanged(space)) {
      measureReaches(space);
    }
    robot_pairs_->value = 0.0;
    object_pairs_->value = 0.0;
    for (Robot& robot : robots_) {
      robot.was_touching = robot.is_touching;
      robot.is_touching = false;
    }
    const auto judge = [&](Row one, Row other) { judgePair(space, one, other); };
    judgeSmall(space, judge);
    judgeLarge(space, judge);
    sum(space);
  }

  /// Radius around the origin that contains the entity in any position of its joints, seen from above [m]; negative
  /// without shapes.
  static double reachOf(const EntityModel& model) {
    if (model.shapes.empty()) {
      return -1.0;
    }
    return model.joints_keep_outline ? model.horizontal_radius : model.moving_reach;
  }

  /// Updates the maximum distance of the origins of two touching entities that are not large.
  void measureReaches(const Space& space) {
    double of_robots = 0.0;
    double of_all = 0.0;
    for (const Row row : space.entities.order) {
      if (!space.index.isLarge(*space.entities.model[row])) {
        const double reach = space.entities.model[row]->moving_reach;
        of_all = std::max(of_all, reach);
        of_robots = isCounted(row) ? std::max(of_robots, reach) : of_robots;
      }
    }
    farthest_ = of_robots + of_all + gap_;
  }

  template <class Judge>
  void judgeSmall(const Space& space, Judge judge) const {
    const auto is_large_meant = [](Row) { return false; };
    space.index.visitPairs(space.entities, farthest_, is_large_meant,
                           [&](Row one, Row other, double) { judge(one, other); });
  }

  /// Compares each of the few large entities, such as walls, with all outlines of the index, which are contiguous in
  /// memory.
  template <class Judge>
  void judgeLarge(const Space& space, Judge judge) const {
    const std::vector<PositionalIndex::LargeOutline>& large = space.index.large();
    const std::size_t places = space.index.placeCount();
    for (std::size_t i = 0; i < large.size(); ++i) {
      const Eigen::Vector2d least = large[i].bounds.min().head<2>();
      const Eigen::Vector2d greatest = large[i].bounds.max().head<2>();
      for (std::size_t place = 0; place < places; ++place) {
        const PositionalIndex::Outline& small = space.index.at(static_cast<PositionalIndex::Place>(place));
        const double reach = small.radius + gap_;
        if (((small.position.array() >= least.array() - reach) && (small.position.array() <= greatest.array() + reach))
                .all()) {
          judge(large[i].row, small.row);
        }
      }
      for (std::size_t k = i + 1; k < large.size(); ++k) {
        judge(large[i].row, large[k].row);
      }
    }
  }

  bool isCounted(Row row) const { return group().placeOf(row) != RobotGroup::kNoPlace; }

  void judgePair(const Space& space, Row one, Row other) {
    const EntityModel& of_one = *space.entities.model[one];
    const EntityModel& of_other = *space.entities.model[other];
    const double reach = reachOf(of_one) + reachOf(of_other) + gap_;
    const Eigen::Vector3d way = space.entities.pose[one].position - space.entities.pose[other].position;
    if (!(isCounted(one) || isCounted(other)) || of_one.shapes.empty() || of_other.shapes.empty() ||
        way.head<2>().squaredNorm() > reach * reach || areConnected(space, one, other) || !doTouch(space, one, other)) {
      return;
    }
    (of_one.is_robot && of_other.is_robot ? robot_pairs_ : object_pairs_)->value += 1.0;
    for (const Row row : {one, other}) {
      if (isCounted(row)) {
        robots_[static_cast<std::size_t>(group().placeOf(row))].is_touching = true;
      }
    }
  }

  bool doTouch(const Space& space, Row one, Row other) {
    footprintsOf(space, one, of_one_);
    footprintsOf(space, other, of_other_);
    return std::any_of(of_one_.begin(), of_one_.end(), [&](const Footprint& a) {
      return std::any_of(of_other_.begin(), of_other_.end(),
                         [&](const Footprint& b) { return areTouching(a, b, gap_); });
    });
  }

  /// Whether one holds the other, which is not a collision.
  static bool areConnected(const Space& space, Row one, Row other) {
    bool is_held = space.structure.grippedBy(one) == other || space.structure.grippedBy(other) == one;
    if (!space.attachments.isEmpty()) {
      space.attachments.visit(one, [&](std::size_t, const Attachment& holds) { is_held |= holds.held == other; });
      space.attachments.visit(other, [&](std::size_t, const Attachment& holds) { is_held |= holds.held == one; });
    }
    return is_held;
  }

  void sum(const Space& space) {
    double touching = 0.0;
    for (const Robot& robot : robots_) {
      touching += robot.is_touching ? 1.0 : 0.0;
      collisions_->value += robot.is_touching && !robot.was_touching ? 1.0 : 0.0;
    }
    touching_->value = touching;
    if (has_begun_ && !robots_.empty()) {
      time_->value +=
          static_cast<double>(every()) * toSeconds(space.clocktick) * touching / static_cast<double>(robots_.size());
    }
    has_begun_ = true;
  }

  double gap_ = 0.0;           // m
  double farthest_ = 0.0;      // m
  std::vector<Robot> robots_;  // by entity number, in the order of the group
  Population population_;
  bool has_begun_ = false;
  std::vector<Footprint> of_one_;
  std::vector<Footprint> of_other_;
  Metric* robot_pairs_ = nullptr;
  Metric* object_pairs_ = nullptr;
  Metric* touching_ = nullptr;
  Metric* collisions_ = nullptr;
  Metric* time_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::ContactCount)
