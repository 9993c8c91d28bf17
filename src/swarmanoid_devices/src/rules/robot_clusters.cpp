// Clusters: the number and sizes of groups of robots that are near each other.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "measuring_rule.hpp"
#include "swarmanoid_space/index/positional_index_visits.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::devices {
namespace {

class RobotClusters final : public MeasuringRule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "robot_clusters";
    description.summary = "Counts clusters of neighbouring robots, and the robots in them.";
    description.parameters = withParameters(
        {number("distance", "m", "0.34", limits::kLength, "Maximum distance between neighbours of one cluster.")});
    return description;
  }

 private:
  using Place = RobotGroup::Place;

  void read(const Configuration& parameters) override {
    distance_ = parameters.number("distance");
    number_ = &addMetric("number", "", "Clusters; a robot without neighbours is a cluster of its own.");
    mean_size_ = &addMetric("mean_size", "", "Robots in a cluster, in the mean over the clusters.");
    largest_ = &addMetric("largest", "", "Robots in the largest cluster.");
  }

  void archiveOwn(StateArchive& /*state*/) override {}

  /// All metrics are 0 without robots.
  void measure(const Space& space, bool) override {
    parents_.resize(group().rows().size());
    members_.resize(group().rows().size());
    for (std::size_t i = 0; i < parents_.size(); ++i) {
      parents_[i] = static_cast<Place>(i);
      members_[i] = 0;
    }
    const auto is_member = [&](Row row) { return group().placeOf(row) != RobotGroup::kNoPlace; };
    space.index.visitPairs(space.entities, distance_, is_member,
                           [&](Row one, Row other, double) { unite(group().placeOf(one), group().placeOf(other)); });
    count();
  }

  void unite(Place one, Place other) {
    if (one != RobotGroup::kNoPlace && other != RobotGroup::kNoPlace) {
      parents_[static_cast<std::size_t>(rootOf(one))] = rootOf(other);
    }
  }

  /// Clusters are trees of places, each identified by its root, which is its own parent.
  Place rootOf(Place place) {
    while (parents_[static_cast<std::size_t>(place)] != place) {
      Place& parent = parents_[static_cast<std::size_t>(place)];
      parent = parents_[static_cast<std::size_t>(parent)];
      place = parent;
    }
    return place;
  }

  void count() {
    std::size_t clusters = 0;
    std::size_t largest = 0;
    for (std::size_t i = 0; i < parents_.size(); ++i) {
      std::size_t& members = members_[static_cast<std::size_t>(rootOf(static_cast<Place>(i)))];
      clusters += members == 0 ? 1 : 0;
      largest = std::max(largest, ++members);
    }
    number_->value = static_cast<double>(clusters);
    largest_->value = static_cast<double>(largest);
    mean_size_->value = clusters == 0 ? 0.0 : static_cast<double>(parents_.size()) / static_cast<double>(clusters);
  }

  double distance_ = 0.0;             // m
  std::vector<Place> parents_;        // by place in the group
  std::vector<std::size_t> members_;  // size of the cluster with that root
  Metric* number_ = nullptr;
  Metric* mean_size_ = nullptr;
  Metric* largest_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::RobotClusters)
