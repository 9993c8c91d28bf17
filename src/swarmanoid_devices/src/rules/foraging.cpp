// Foraging: counts the preys that robots bring into the nest, and moves each elsewhere in the next tick, so that preys
// never run out. It acts between ticks and only on the space, independent of the engine that moves a prey and of the
// robots that hold it.
#include <algorithm>
#include <vector>

#include "common/parameters.hpp"
#include "floor_patch.hpp"
#include "swarmanoid_space/models/limits.hpp"
#include "swarmanoid_space/rule.hpp"
#include "tally.hpp"
#include "update_members.hpp"

namespace swarmanoid::devices {
namespace {

class Foraging final : public Rule {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    const auto corner = [](const std::string& name, const std::string& description) {
      return makeParameter(name, Type::kVector3, "m", std::nullopt, limits::kCoordinate, description);
    };
    PluginDescription description;
    description.label = "foraging";
    description.summary = "Counts the preys that are brought into the nest, and puts them elsewhere.";
    description.parameters = {
        makeParameter("prey", Type::kText, "", "prey", {}, "Name prefix of the preys."),
        makeParameter("nest", Type::kText, "", "nest", {}, "Id of the floor patch that is the nest."),
        corner("minimum", "Least coordinates of the origins of preys that come back."),
        corner("maximum", "Greatest coordinates of these."),
        integer("enough", "0", {0.0, 1e9}, "Preys after which the run ends, a success; 0: it does not.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    prey_ = parameters.text("prey");
    nest_ = parameters.text("nest");
    minimum_ = parameters.vector3("minimum");
    maximum_ = parameters.vector3("maximum");
    location_ = parameters.location();
    if (prey_.empty()) {
      throw ConfigError(location_, "prey: found '', allowed: what names begin with");
    }
    if (!((maximum_ - minimum_).minCoeff() >= 0.0)) {
      throw ConfigError(location_, "maximum: found '" + parameters.text("maximum") +
                                       "', allowed: nothing below minimum, '" + parameters.text("minimum") + "'");
    }
    Metric& preys = addMetric("preys", "", "Preys that were brought into the nest so far.");
    Metric& per_minute = addMetric("preys_per_minute", "1/min", "Number per minute of simulated time.");
    tally_ = Tally(preys, per_minute, static_cast<double>(parameters.integer("enough")));
    preys_ = &preys;
    per_kilojoule_ =
        &addMetric("preys_per_kilojoule", "1/kJ", "Number per kJ that robots on batteries have used; 0 without use.");
  }

  void reset(const Space& space, InterventionQueue&) override {
    waiting_.clear();
    robots_.clear();
    used_by_deleted_ = 0.0;
    nest_patch_ = requireFloorPatch(space, "nest", nest_, location_);
  }

  void afterTick(const Space& space, InterventionQueue& queue) override {
    const FloorPatch& nest = space.floor.patches[nest_patch_];
    forgetThoseThatAreBack(space);
    for (const Row row : space.entities.order) {
      const bool is_prey = space.entities.name[row].compare(0, prey_.size(), prey_) == 0;
      if (!is_prey || !space.entities.model[row]->is_movable) {
        continue;
      }
      const EntityNumber number = space.entities.number[row];
      if (!isWaiting(number) && nest.contains(space.entities.pose[row].position)) {
        tally_.add();
        waiting_.push_back({number, space.tick});
      }
      if (isWaiting(number)) {
        tryToPutElsewhere(space.entities.name[row], nest, queue);
      }
    }
    tally_.measure(space);
    per_kilojoule_->value = perKilojoule(space);
  }

  bool isFinished() const override { return tally_.isEnough(); }
  std::optional<bool> success() const override { return tally_.success(); }

  void archive(StateArchive& state) override { state(waiting_, robots_, used_by_deleted_); }

 private:
  /// A counted prey that has not been moved yet, since no free place was found.
  struct Waiting {
    EntityNumber number = kNoEntity;
    std::uint64_t since = 0;  ///< Space::tick when it was counted: the next tick
  };

  /// A robot on a battery.
  struct Robot {
    EntityNumber number = kNoEntity;
    double used = 0.0;  // J, at the end of the last tick
  };

  /// The energy used by deleted robots still counts, like the preys that they brought.
  double perKilojoule(const Space& space) {
    constexpr double kKilojoule = 1000.0;  // J
    for (const Robot& robot : robots_) {
      used_by_deleted_ += space.entities.find(robot.number) == kNoRow ? robot.used : 0.0;
    }
    const auto is_meant = [](Row) { return true; };
    updateMembers(space, space.powered, is_meant, robots_);
    double used = 0.0;  // J
    for (Robot& robot : robots_) {
      robot.used = space.batteries[space.entities.find(robot.number)][0].used;
      used += robot.used;
    }
    used += used_by_deleted_;
    return used > 0.0 ? preys_->value * kKilojoule / used : 0.0;
  }

  bool isWaiting(EntityNumber number) const {
    return std::any_of(waiting_.begin(), waiting_.end(),
                       [number](const Waiting& waiting) { return waiting.number == number; });
  }

  /// Removes preys that have been moved or deleted.
  void forgetThoseThatAreBack(const Space& space) {
    const auto isBack = [&space](const Waiting& waiting) {
      const Row row = space.entities.find(waiting.number);
      return row == kNoRow || space.placed[row] >= waiting.since;
    };
    waiting_.erase(std::remove_if(waiting_.begin(), waiting_.end(), isBack), waiting_.end());
  }

  /// The world refuses occupied places; the rule then tries again after the next tick.
  void tryToPutElsewhere(const std::string& prey, const FloorPatch& nest, InterventionQueue& queue) {
    Pose pose;  // upright, whatever its pose in the gripper
    for (int axis = 0; axis < 3; ++axis) {
      pose.position[axis] = random().uniform(minimum_[axis], maximum_[axis]);
    }
    if (!nest.contains(pose.position)) {
      queue.tryTo(MoveEntity{prey, pose});
    }
  }

  std::string prey_;
  std::string nest_;
  std::size_t nest_patch_ = 0;
  Eigen::Vector3d minimum_ = Eigen::Vector3d::Zero();  // m
  Eigen::Vector3d maximum_ = Eigen::Vector3d::Zero();  // m
  SourceLocation location_;
  Tally tally_;
  const Metric* preys_ = nullptr;
  Metric* per_kilojoule_ = nullptr;
  std::vector<Waiting> waiting_;
  std::vector<Robot> robots_;     // by entity number
  double used_by_deleted_ = 0.0;  // J, in this run
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::Foraging)
