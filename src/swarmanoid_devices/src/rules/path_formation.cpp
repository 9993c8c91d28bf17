// A path of robots: whether robots with lit LEDs connect one entity to another, each within reach of the next.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/parameters.hpp"
#include "named_entity.hpp"
#include "surroundings/lit_entities.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::devices {
namespace {

class PathFormation final : public Rule {
 public:
  static PluginDescription describe() {
    using Type = Parameter::Type;
    PluginDescription description;
    description.label = "path_formation";
    description.summary = "Measures when robots that shine make a path from one entity to another.";
    description.parameters = {
        makeParameter("nest", Type::kText, "", "nest", {}, "Id of the entity where the path begins."),
        makeParameter("prey", Type::kText, "", "prey", {}, "Id of the one where it ends."),
        number("reach", "m", "1", {0.001, 10000.0},
               "Maximum distance between neighbours in the path, seen from above."),
        boolean("ends", "true", "Whether the run ends with the first path, and is a success only then.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    ids_[0] = parameters.text("nest");
    ids_[1] = parameters.text("prey");
    reach_ = parameters.number("reach");
    ends_ = parameters.boolean("ends");
    location_ = parameters.location();
    links_ = &addMetric("links", "", "Robots that shine.");
    length_ = &addMetric("length", "", "Robots in the path with the fewest robots; 0 without a path.");
    formation_time_ = &addMetric("formation_time", "s", "Time of the first path; until then the current time.");
  }

  void reset(const Space& space, InterventionQueue&) override {
    is_formed_ = false;
    requireEntity(space, "nest", ids_[0], location_);
    requireEntity(space, "prey", ids_[1], location_);
  }

  void afterTick(const Space& space, InterventionQueue&) override {
    const Row nest = space.entities.find(ids_[0]);
    const Row prey = space.entities.find(ids_[1]);
    for (std::vector<Row>* rows : {&unreached_, &front_, &next_front_}) {
      rows->reserve(space.entities.order.size());  // allocates only when the number of entities grows
    }
    unreached_.clear();
    for (const Row row : space.entities.order) {
      const bool is_end = row == nest || row == prey;
      if (!is_end && space.entities.model[row]->is_robot && isAnyLit(space.leds[row])) {
        unreached_.push_back(row);
      }
    }
    links_->value = static_cast<double>(unreached_.size());
    length_->value = nest == kNoRow || prey == kNoRow ? 0.0 : measure(space, nest, prey);
    if (!is_formed_) {
      is_formed_ = length_->value > 0.0;
      formation_time_->value = toSeconds(space.time - kEpoch);
    }
  }

  bool isFinished() const override { return ends_ && is_formed_; }
  std::optional<bool> success() const override { return ends_ ? std::optional<bool>(is_formed_) : std::nullopt; }

  void archive(StateArchive& state) override { state(is_formed_); }

 private:
  bool areInReach(const Space& space, Row one, Row other) const {
    const Eigen::Vector3d way = space.entities.pose[one].position - space.entities.pose[other].position;
    return way.head<2>().norm() <= reach_;
  }

  /// Breadth-first search from the nest, one link in each pass. @return robots in the shortest path, or 0
  double measure(const Space& space, Row nest, Row prey) {
    front_.assign(1, nest);
    for (double length = 1.0; !front_.empty(); length += 1.0) {
      next_front_.clear();
      for (const Row from : front_) {
        for (std::size_t i = 0; i < unreached_.size();) {
          if (!areInReach(space, from, unreached_[i])) {
            ++i;
            continue;
          }
          if (areInReach(space, unreached_[i], prey)) {
            return length;
          }
          next_front_.push_back(unreached_[i]);
          unreached_[i] = unreached_.back();
          unreached_.pop_back();
        }
      }
      std::swap(front_, next_front_);
    }
    return 0.0;
  }

  std::array<std::string, 2> ids_;  // of nest and prey
  double reach_ = 1.0;              // m
  bool ends_ = true;
  bool is_formed_ = false;  // since the run began
  SourceLocation location_;
  std::vector<Row> unreached_;  // robots with lit LEDs that no front has reached
  std::vector<Row> front_;      // robots at the current distance from the nest, in links
  std::vector<Row> next_front_;
  Metric* links_ = nullptr;
  Metric* length_ = nullptr;
  Metric* formation_time_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::PathFormation)
