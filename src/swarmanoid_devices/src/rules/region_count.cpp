// Counts the robots or objects in a region, and judges whether they are enough for a success.
#include <algorithm>
#include <string>
#include <vector>

#include "measuring_rule.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::devices {
namespace {

class RegionCount final : public MeasuringRule {
 public:
  static PluginDescription describe() {
    const auto corner = [](const std::string& name, const std::string& description) {
      return makeParameter(name, Parameter::Type::kVector3, "m", std::nullopt, limits::kCoordinate, description);
    };
    PluginDescription description;
    description.label = "region_count";
    description.summary = "Counts the robots, or objects, whose origins are in a region.";
    description.parameters = withParameters(
        {makeParameter("objects", Parameter::Type::kText, "", "", {},
                       "Name prefix of objects that are counted in place of robots; empty: robots are counted."),
         corner("minimum", "Least coordinates of the region."),
         corner("maximum", "Greatest coordinates of the region."),
         integer("enough", "0", {0.0, 1e9}, "How many in the region are a success; 0: it is not judged."),
         boolean("ends", "false", "Whether the run ends when so many are in the region.")});
    return description;
  }

  bool isFinished() const override { return ends_ && isEnough(); }
  std::optional<bool> success() const override {
    return enough_ > 0.0 ? std::optional<bool>(isEnough()) : std::nullopt;
  }

 private:
  void read(const Configuration& parameters) override {
    objects_ = parameters.text("objects");
    minimum_ = parameters.vector3("minimum");
    maximum_ = parameters.vector3("maximum");
    enough_ = static_cast<double>(parameters.integer("enough"));
    ends_ = parameters.boolean("ends");
    if (!((maximum_ - minimum_).minCoeff() >= 0.0)) {
      throw ConfigError(parameters.find("maximum")->location(), "maximum: found '" + parameters.text("maximum") +
                                                                    "', allowed: nothing below minimum, '" +
                                                                    parameters.text("minimum") + "'");
    }
    if (ends_ && enough_ == 0.0) {
      throw ConfigError(parameters.find("ends")->location(), "ends: found 'true', allowed: only with enough above 0");
    }
    inside_ = &addMetric("inside", "", "How many are in the region.");
    mean_ = &addMetric("mean", "", "Its mean over the measurements of the run.");
    most_ = &addMetric("most", "", "The greatest of them.");
  }

  void archiveOwn(StateArchive& state) override {
    state(measurements_);
    if (state.isLoading()) {
      population_ = {};
    }
  }

  void start(const Space&) override {
    population_ = {};
    measurements_ = 0.0;
  }

  void measure(const Space& space, bool) override {
    if (!objects_.empty() && population_.hasChanged(space)) {
      updateObjects(space);
    }
    double inside = 0.0;
    for (const Row row : objects_.empty() ? group().rows() : rows_) {
      const Eigen::Array3d position = space.entities.pose[row].position.array();
      inside += (position >= minimum_.array()).all() && (position <= maximum_.array()).all() ? 1.0 : 0.0;
    }
    measurements_ += 1.0;
    inside_->value = inside;
    mean_->value += (inside - mean_->value) / measurements_;
    most_->value = std::max(most_->value, inside);
  }

  void updateObjects(const Space& space) {
    rows_.clear();
    rows_.reserve(space.entities.size());
    for (const Row row : space.entities.order) {
      const bool is_meant = space.entities.name[row].compare(0, objects_.size(), objects_) == 0;
      if (is_meant && !space.entities.model[row]->is_robot) {
        rows_.push_back(row);
      }
    }
  }

  bool isEnough() const { return inside_->value >= enough_; }

  std::string objects_;
  Eigen::Vector3d minimum_ = Eigen::Vector3d::Zero();  // m
  Eigen::Vector3d maximum_ = Eigen::Vector3d::Zero();  // m
  double enough_ = 0.0;
  bool ends_ = false;
  Population population_;
  std::vector<Row> rows_;  // of the objects
  double measurements_ = 0.0;
  Metric* inside_ = nullptr;
  Metric* mean_ = nullptr;
  Metric* most_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::RegionCount)
