// Dispersion: how far apart robots are, to judge aggregation. Both measures are those of Gauci, Chen, Li, Dodd and
// Gross, "Self-organized aggregation without computation" (2014). The rule only measures.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "common/parameters.hpp"
#include "robot_group.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::devices {
namespace {

class Dispersion final : public Rule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "dispersion";
    description.summary = "Measures how far apart robots are.";
    description.parameters = {RobotGroup::parameter(),
                              number("radius", "m", "0.085", {1e-4, 100.0}, "Of a robot, seen from above.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    group_ = RobotGroup(parameters.text("robots"));
    radius_ = parameters.number("radius");
    second_moment_ =
        &addMetric("second_moment", "", "Sum of squared distances from the centroid, in squared diameters.");
    largest_cluster_ = &addMetric("largest_cluster", "", "Part of the robots that is in the largest cluster.");
  }

  void afterTick(const Space& space, InterventionQueue&) override {
    group_.look(space);
    const Eigen::Vector2d centroid = group_.centroid(space).value_or(Eigen::Vector2d::Zero());  // unused without robots
    places_.clear();
    places_.reserve(space.entities.order.size());  // robots may have been added since the run began
    double sum = 0.0;
    for (const Row row : group_.rows()) {
      const Eigen::Vector2d position = space.entities.pose[row].position.head<2>();
      places_.push_back({position, 0, 0});
      sum += (position - centroid).squaredNorm();
    }
    second_moment_->value = sum / (4.0 * radius_ * radius_);
    largest_cluster_->value =
        places_.empty() ? 0.0 : static_cast<double>(largestCluster()) / static_cast<double>(places_.size());
  }

  void archive(StateArchive& state) override { state(group_); }

 private:
  /// Position of a robot. Clusters are trees of such places, each identified by its root.
  struct Place {
    Eigen::Vector2d position;
    std::size_t parent = 0;   // index of the parent; its own index for a root
    std::size_t members = 0;  // size of a root's cluster
  };

  std::size_t rootOf(std::size_t place) {
    while (places_[place].parent != place) {
      places_[place].parent = places_[places_[place].parent].parent;
      place = places_[place].parent;
    }
    return place;
  }

  /// Two robots are in one cluster if no third one fits between them, or if a chain of such pairs connects them.
  std::size_t largestCluster() {
    const double reach = 4.0 * radius_;
    // the order of places with equal x only changes which root identifies a cluster, not its size
    std::sort(places_.begin(), places_.end(),
              [](const Place& a, const Place& b) { return a.position.x() < b.position.x(); });
    for (std::size_t i = 0; i < places_.size(); ++i) {
      places_[i].parent = i;
    }
    for (std::size_t i = 0; i < places_.size(); ++i) {
      for (std::size_t j = i + 1; j < places_.size() && places_[j].position.x() - places_[i].position.x() < reach;
           ++j) {
        if ((places_[j].position - places_[i].position).squaredNorm() < reach * reach) {
          places_[rootOf(j)].parent = rootOf(i);
        }
      }
    }
    std::size_t largest = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      largest = std::max(largest, ++places_[rootOf(i)].members);
    }
    return largest;
  }

  RobotGroup group_;
  double radius_ = 0.0;  // m
  std::vector<Place> places_;
  Metric* second_moment_ = nullptr;
  Metric* largest_cluster_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::Dispersion)
