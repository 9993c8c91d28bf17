#include "swarmanoid_space/device_drawing.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {
namespace {

constexpr double kTurn = 2.0 * M_PI;

/// @param word a name, or a prefix followed by *
bool fits(std::string_view word, std::string_view name) {
  if (word.empty() || word.back() != '*') {
    return word == name;
  }
  word.remove_suffix(1);
  return name.substr(0, word.size()) == word;
}

}  // namespace

bool DrawnRobots::has(std::string_view robot) const {
  return is_all || std::any_of(names.begin(), names.end(), [&](const std::string& word) { return fits(word, robot); });
}

DrawnRobots chooseDrawnRobots(const std::vector<std::string>& words, const std::string& parameter,
                              const Experiment& experiment) {
  if (words.empty() || words == std::vector<std::string>{"all"}) {
    return {};
  }
  const std::vector<std::string> robots = robotNames(experiment);
  for (const std::string& word : words) {
    if (std::none_of(robots.begin(), robots.end(), [&](const std::string& robot) { return fits(word, robot); })) {
      throw ConfigError({experiment.file, 0}, parameter + ": found '" + word +
                                                  "', allowed: all, or beginnings of names that end with *, or " +
                                                  joinNames(robots) + didYouMean(word, robots));
    }
  }
  return {false, words};
}

void DeviceDrawing::line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Color color) {
  lines_.push_back({from, to, color});
  is_used_ = true;
}

void DeviceDrawing::point(const Eigen::Vector3d& place, Color color) {
  points_.push_back({place, color});
  is_used_ = true;
}

void DeviceDrawing::arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Color color) {
  constexpr double kHead = 0.2;  // as a fraction of the length
  line(from, to, color);
  const Eigen::Vector3d back = kHead * (from - to);
  const double level = back.head<2>().norm();
  // perpendicular to the arrow in a vertical plane; along x for a vertical arrow
  const Eigen::Vector3d aside = level > 1e-9
                                    ? Eigen::Vector3d(-back.x() * back.z() / level, -back.y() * back.z() / level, level)
                                    : Eigen::Vector3d(back.norm(), 0.0, 0.0);
  line(to, to + back + 0.5 * aside, color);
  line(to, to + back - 0.5 * aside, color);
}

void DeviceDrawing::arc(const Eigen::Vector3d& centre, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double first,
                        double last, Color color) {
  constexpr double kLongest = kTurn / 24.0;
  const int pieces = std::max(1, static_cast<int>(std::ceil((last - first) / kLongest - 1e-9)));
  const auto at = [&](int i) -> Eigen::Vector3d {
    const double angle = first + i * (last - first) / pieces;
    return centre + std::cos(angle) * a + std::sin(angle) * b;
  };
  for (int i = 0; i < pieces; ++i) {
    line(at(i), at(i + 1), color);
  }
}

void DeviceDrawing::circle(const Eigen::Vector3d& centre, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                           Color color) {
  arc(centre, a, b, 0.0, kTurn, color);
}

void DeviceDrawing::cone(const Eigen::Vector3d& tip, const Eigen::Vector3d& centre, const Eigen::Vector3d& a,
                         const Eigen::Vector3d& b, Color color) {
  circle(centre, a, b, color);
  for (const Eigen::Vector3d& edge : {a, b}) {
    line(tip, centre + edge, color);
    line(tip, centre - edge, color);
  }
}

void DeviceDrawing::clear() {
  lines_.clear();
  points_.clear();
}

Color DeviceDrawing::shade(double reading) {
  constexpr Color kNothing{110, 140, 190};
  const double share = std::clamp(reading, 0.0, 1.0);
  const auto mix = [share](int nothing, int all) {
    return static_cast<std::uint8_t>(std::lround(nothing + share * (all - nothing)));
  };
  return {mix(kNothing.red, colors::kRed.red), mix(kNothing.green, colors::kRed.green),
          mix(kNothing.blue, colors::kRed.blue)};
}

DeviceDrawing& DeviceDrawings::of(std::string_view type) {
  auto found = drawings_.find(type);
  if (found == drawings_.end()) {
    found = drawings_.emplace(std::string(type), DeviceDrawing(robots_)).first;
  }
  return found->second;
}

void DeviceDrawings::clear() {
  for (auto& [type, drawing] : drawings_) {
    drawing.clear();
  }
}

}  // namespace swarmanoid
