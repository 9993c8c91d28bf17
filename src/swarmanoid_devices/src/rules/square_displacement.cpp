// Mean square displacement of robots from their starting points, the measure of random walks. By Einstein, "On the
// movement of small particles suspended in stationary liquids" (1905), it grows as 4 D t in a plane.
#include <algorithm>
#include <cmath>
#include <vector>

#include "measuring_rule.hpp"
#include "update_members.hpp"

namespace swarmanoid::devices {
namespace {

class SquareDisplacement final : public MeasuringRule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "square_displacement";
    description.summary = "Measures how far robots have come from where they began.";
    description.parameters = withParameters({});
    return description;
  }

 private:
  /// A robot, with the position and time of its first measurement.
  struct Beginning {
    EntityNumber number = kNoEntity;
    Eigen::Vector2d position = Eigen::Vector2d::Zero();  // m
    Time time = kEpoch;
    bool is_known = false;
  };

  void read(const Configuration&) override {
    mean_square_ =
        &addMetric("mean_square", "m2", "Mean square of the ways from where robots began, as the crow flies.");
    farthest_ = &addMetric("farthest", "m", "The longest of these ways.");
    diffusivity_ = &addMetric("diffusivity", "m2/s", "Sum of the squares by four times the sum of the robots' times.");
  }

  void archiveOwn(StateArchive& state) override { state(beginnings_); }

  void start(const Space&) override { beginnings_.clear(); }

  /// All metrics are 0 without robots.
  void measure(const Space& space, bool is_changed) override {
    if (is_changed) {
      updateBeginnings(space);
    }
    double squares = 0.0;   // m2
    double greatest = 0.0;  // m2
    double times = 0.0;     // s
    for (std::size_t i = 0; i < beginnings_.size(); ++i) {
      const Eigen::Vector2d position = space.entities.pose[group().rows()[i]].position.head<2>();
      const double square = (position - beginnings_[i].position).squaredNorm();
      squares += square;
      greatest = std::max(greatest, square);
      times += toSeconds(space.time - beginnings_[i].time);
    }
    mean_square_->value = beginnings_.empty() ? 0.0 : squares / static_cast<double>(beginnings_.size());
    farthest_->value = std::sqrt(greatest);
    diffusivity_->value = times > 0.0 ? squares / (4.0 * times) : 0.0;
  }

  /// Records the starting points of new robots. Afterwards the list has the order of the group.
  void updateBeginnings(const Space& space) {
    const auto is_meant = [](Row) { return true; };
    updateMembers(space, group().rows(), is_meant, beginnings_);
    for (std::size_t i = 0; i < beginnings_.size(); ++i) {
      if (!beginnings_[i].is_known) {
        const Row row = group().rows()[i];
        beginnings_[i] = {space.entities.number[row], space.entities.pose[row].position.head<2>(), space.time, true};
      }
    }
  }

  std::vector<Beginning> beginnings_;  // by entity number
  Metric* mean_square_ = nullptr;
  Metric* farthest_ = nullptr;
  Metric* diffusivity_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::SquareDisplacement)
