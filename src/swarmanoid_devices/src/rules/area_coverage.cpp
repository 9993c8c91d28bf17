// Coverage: the share of an area that robots have visited so far, by squares.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "measuring_rule.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::devices {
namespace {

class AreaCoverage final : public MeasuringRule {
 public:
  static PluginDescription describe() {
    const auto corner = [](const std::string& name, const std::string& description) {
      return makeParameter(name, Parameter::Type::kVector2, "m", "", limits::kCoordinate, description);
    };
    PluginDescription description;
    description.label = "area_coverage";
    description.summary = "Measures which part of an area robots have visited.";
    description.parameters =
        withParameters({corner("minimum", "Least coordinates of the area; empty: those of the arena."),
                        corner("maximum", "Greatest coordinates of the area; empty: those of the arena."),
                        number("cell", "m", "0.5", limits::kLength, "Side of the squares into which it is divided.")});
    return description;
  }

 private:
  void read(const Configuration& parameters) override {
    parameters_ = parameters;
    cell_ = parameters.number("cell");
    share_ = &addMetric("share", "", "Squares that some robot has visited, by all squares.");
    area_ = &addMetric("area", "m2", "Of the squares that some robot has visited.");
  }

  void archiveOwn(StateArchive& state) override { state(is_visited_, visited_); }

  void start(const Space& space) override {
    const Eigen::AlignedBox2d arena(Eigen::Vector2d(space.corner.head<2>()),
                                    Eigen::Vector2d(space.farCorner().head<2>()));
    minimum_ = cornerOr("minimum", arena.min(), arena);
    const Eigen::Vector2d maximum = cornerOr("maximum", arena.max(), arena);
    const Eigen::Vector2d size = maximum - minimum_;
    constexpr double kRounding = 1e-9;  // as a fraction of a square, so that 3 m / 0.1 m is 30
    const Eigen::Array2d count = (size.array() / cell_ + kRounding).floor();
    if (!(count.minCoeff() >= 1.0)) {
      refuse("cell", "at most the shorter side of the area, " + numberText(size.minCoeff()));
    }
    constexpr double kMostSquares = 1e7;
    if (count.prod() > kMostSquares) {
      refuse("cell", "at least " + numberText(std::sqrt(size.prod() / kMostSquares)) + ", for ten million squares");
    }
    count_ = count.cast<int>();
    is_visited_.assign(static_cast<std::size_t>(count.prod()), 0);
    visited_ = 0;
  }

  void measure(const Space& space, bool) override {
    for (const Row row : group().rows()) {
      const Eigen::Array2d place = (space.entities.pose[row].position.head<2>() - minimum_).array() / cell_;
      if ((place >= 0.0).all() && (place < count_.cast<double>()).all()) {
        const auto square = static_cast<std::size_t>(place.y()) * static_cast<std::size_t>(count_.x()) +
                            static_cast<std::size_t>(place.x());
        visited_ += is_visited_[square] == 0 ? 1 : 0;
        is_visited_[square] = 1;
      }
    }
    share_->value = static_cast<double>(visited_) / static_cast<double>(is_visited_.size());
    area_->value = static_cast<double>(visited_) * cell_ * cell_;
  }

  /// @param otherwise default for an empty parameter @throws ConfigError if the corner is not in the arena
  Eigen::Vector2d cornerOr(const std::string& name, const Eigen::Vector2d& otherwise,
                           const Eigen::AlignedBox2d& arena) const {
    if (parameters_.text(name).empty()) {
      return otherwise;
    }
    Eigen::Vector2d corner = parameters_.vector2(name);
    if (!arena.contains(corner)) {
      refuse(name, "in the arena, from " + textOf(arena.min()) + " to " + textOf(arena.max()));
    }
    return corner;
  }

  static std::string textOf(const Eigen::Vector2d& v) { return numberText(v.x()) + ", " + numberText(v.y()); }

  [[noreturn]] void refuse(const std::string& name, const std::string& allowed) const {
    throw ConfigError(parameters_.find(name)->location(),
                      name + ": found '" + parameters_.text(name) + "', allowed: " + allowed);
  }

  Configuration parameters_;
  double cell_ = 0.0;                                  // m
  Eigen::Vector2d minimum_ = Eigen::Vector2d::Zero();  // m
  Eigen::Array2i count_ = Eigen::Array2i::Zero();      // number of squares along x and y
  std::vector<char> is_visited_;                       // row by row
  std::size_t visited_ = 0;
  Metric* share_ = nullptr;
  Metric* area_ = nullptr;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_RULE(swarmanoid::devices::AreaCoverage)
