// Order of a swarm: whether robots head in one direction, and whether they rotate around their centre. After Couzin,
// Krause, James, Ruxton and Franks, "Collective memory and spatial sorting in animal groups" (2002).
#include <cmath>

#include "measuring_rule.hpp"

namespace swarmanoid::devices {
namespace {

/// @return the vector scaled to length 1; zero for a zero vector
Eigen::Vector2d directionOf(const Eigen::Vector2d& vector) {
  const double length = vector.norm();
  return length > 0.0 ? Eigen::Vector2d(vector / length) : Eigen::Vector2d(Eigen::Vector2d::Zero());
}

class SwarmOrder final : public MeasuringRule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "swarm_order";
    description.summary = "Measures whether robots head in one direction, or around their centre.";
    description.parameters = withParameters({});
    return description;
  }

 private:
  void read(const Configuration&) override {
    polarisation_ = &addMetric("polarisation", "", "Length of the mean of the robots' headings as vectors.");
    angular_order_ = &addMetric("angular_order", "", "How far they head around their centroid, in the mean.");
  }

  void archiveOwn(StateArchive& /*state*/) override {}

  /// All metrics are 0 without robots.
  void measure(const Space& space, bool) override {
    const Eigen::Vector2d centroid = group().centroid(space).value_or(Eigen::Vector2d::Zero());
    Eigen::Vector2d headings = Eigen::Vector2d::Zero();
    double turns = 0.0;
    for (const Row row : group().rows()) {
      const Pose& pose = space.entities.pose[row];
      const Eigen::Vector2d heading = directionOf((pose.orientation * Eigen::Vector3d::UnitX()).head<2>());
      const Eigen::Vector2d outwards = directionOf(pose.position.head<2>() - centroid);
      headings += heading;
      turns += outwards.x() * heading.y() - outwards.y() * heading.x();
    }
    const double share = group().rows().empty() ? 0.0 : 1.0 / static_cast<double>(group().rows().size());
    polarisation_->value = share * headings.norm();
    angular_order_->value = share * std::abs(turns);
  }

  Metric* polarisation_ = nullptr;
  Metric* angular_order_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::SwarmOrder)
