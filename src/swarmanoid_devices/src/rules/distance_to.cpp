// Distance: of robots from a position, from a line, or from the nearest entity of a type.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "measuring_rule.hpp"
#include "nearest_of_kind.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::devices {
namespace {

/// A line segment; both ends may be equal.
struct Line {
  Eigen::Vector2d start;  // m
  Eigen::Vector2d end;    // m

  double squaredDistance(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d along = end - start;
    const double length = along.squaredNorm();
    const double part = length > 0.0 ? std::clamp((point - start).dot(along) / length, 0.0, 1.0) : 0.0;
    return (start + part * along - point).squaredNorm();
  }
};

class DistanceTo final : public MeasuringRule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "distance_to";
    description.summary = "Measures how far robots are from a place, a line, or the nearest entity of a kind.";
    description.parameters = withParameters({makeParameter(
        "to", Parameter::Type::kText, "", std::nullopt, {},
        "Target of the distances: x, y of a place, x, y, x, y of the ends of a line, or an entity type.")});
    return description;
  }

 private:
  void read(const Configuration& parameters) override {
    to_ = parameters.text("to");
    location_ = parameters.find("to")->location();
    line_ = readLine();
    mean_ = &addMetric("mean", "m", "Distance, in the mean over the robots.");
    least_ = &addMetric("least", "m", "Of the robot that is nearest.");
    greatest_ = &addMetric("greatest", "m", "Of the robot that is farthest.");
  }

  void archiveOwn(StateArchive& state) override { state(nearest_); }

  /// @return nothing if the text is a word
  std::optional<Line> readLine() const {
    const bool is_word = !to_.empty() && std::isalpha(static_cast<unsigned char>(to_.front())) != 0;
    if (is_word) {
      return std::nullopt;
    }
    const auto commas = std::count(to_.begin(), to_.end(), ',');
    if (commas != 1 && commas != 3) {
      throw ConfigError(location_, "to: found '" + to_ + "', allowed: two numbers, four numbers, or an entity type");
    }
    const std::vector<double> numbers =
        parseNumbers(to_, static_cast<std::size_t>(commas) + 1, "to", location_, limits::kCoordinate);
    return Line{{numbers[0], numbers[1]}, {numbers[numbers.size() - 2], numbers.back()}};
  }

  void start(const Space&) override {
    if (line_) {
      return;
    }
    const Registry& registry = Registry::instance();
    const Registry::Entry* entry = registry.find(PluginKind::kEntity, to_);
    if (entry == nullptr) {
      throw ConfigError(location_, "to: " + unknownName("the entity type", to_, registry.labels(PluginKind::kEntity)));
    }
    nearest_ = NearestOfKind(entry->description.label);
  }

  /// Without a robot or a target the metrics keep their values.
  void measure(const Space& space, bool) override {
    if (!line_) {
      set(nearest_.look(space, group()));
      return;
    }
    squares_.clear();
    squares_.reserve(group().rows().size());
    for (const Row row : group().rows()) {
      squares_.push_back(line_->squaredDistance(space.entities.pose[row].position.head<2>()));
    }
    set(squares_);
  }

  void set(const std::vector<double>& squares) {
    double sum = 0.0;
    double count = 0.0;
    double least = kInfinity;
    double greatest = 0.0;
    for (const double square : squares) {
      if (square < kInfinity) {
        sum += std::sqrt(square);
        count += 1.0;
        least = std::min(least, square);
        greatest = std::max(greatest, square);
      }
    }
    if (count > 0.0) {
      mean_->value = sum / count;
      least_->value = std::sqrt(least);
      greatest_->value = std::sqrt(greatest);
    }
  }

  std::string to_;
  SourceLocation location_;
  std::optional<Line> line_;  // a position is a line of length 0
  NearestOfKind nearest_;     // used without a line
  std::vector<double> squares_;
  Metric* mean_ = nullptr;
  Metric* least_ = nullptr;
  Metric* greatest_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::DistanceTo)
