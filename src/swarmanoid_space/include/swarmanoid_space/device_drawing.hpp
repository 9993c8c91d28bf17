/// What devices do, drawn for people: rays, fields of view, links between robots, as coloured lines and points in W
/// [m].
///
/// A device draws (`drawOne` of SensorOf and ActuatorOf) when somebody looks, in `show` or between ticks, and at no
/// other time. Engines have moved since it sensed, so what lies in the space is drawn where it is now: where a ray
/// ends, between whom a message went. Colours and lengths that stand for readings are those that the robot's controller
/// got in this tick, with all errors. Drawing changes nothing: a run that is looked at is the same run.
///
/// Whose devices are drawn is the viewer's choice (DrawnRobots): a device is asked for those robots only.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "swarmanoid_interface/color.hpp"

namespace swarmanoid {

struct Experiment;

/// The robots whose devices are drawn.
struct DrawnRobots {
  bool is_all = true;
  std::vector<std::string> names;  ///< if not all: names, or beginnings of names that end with *

  bool has(std::string_view robot) const;
};

/// @param words names, beginnings that end with *, or "all" alone; none at all mean "all"
/// @throws ConfigError for a word that fits no robot of the experiment; the message begins with the parameter's name
DrawnRobots chooseDrawnRobots(const std::vector<std::string>& words, const std::string& parameter,
                              const Experiment& experiment);

/// The drawing of all devices of one type. What is drawn keeps its room over `clear`.
class DeviceDrawing {
 public:
  struct Line {
    Eigen::Vector3d from;
    Eigen::Vector3d to;
    Color color;
  };
  struct Point {
    Eigen::Vector3d place;
    Color color;
  };

  explicit DeviceDrawing(DrawnRobots robots = {}) : robots_(std::move(robots)) {}

  /// Whether the devices of a robot are drawn; asked before `drawOne`.
  bool isOf(std::string_view robot) const { return robots_.has(robot); }

  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Color color);
  void point(const Eigen::Vector3d& place, Color color);
  /// With a head of two strokes, a fifth as long, in the upright plane that it lies in.
  void arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Color color);
  /// The points centre + cos(t) * a + sin(t) * b from t = first to last [rad], by straight pieces of at most 15
  /// degrees.
  void arc(const Eigen::Vector3d& centre, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double first, double last,
           Color color);
  /// That arc all the way round.
  void circle(const Eigen::Vector3d& centre, const Eigen::Vector3d& a, const Eigen::Vector3d& b, Color color);
  /// Such a circle, and from it four lines to the tip.
  void cone(const Eigen::Vector3d& tip, const Eigen::Vector3d& centre, const Eigen::Vector3d& a,
            const Eigen::Vector3d& b, Color color);

  const std::vector<Line>& lines() const { return lines_; }
  const std::vector<Point>& points() const { return points_; }
  /// Whether anything was ever drawn: devices without a look of their own need no place in a display.
  bool isUsed() const { return is_used_; }
  void clear();

  static constexpr Color kOutline{120, 130, 150};  ///< of fields of view
  /// For a reading from 0 (a bluish grey) to 1 (red).
  static Color shade(double reading);

 private:
  DrawnRobots robots_;
  std::vector<Line> lines_;
  std::vector<Point> points_;
  bool is_used_ = false;
};

/// The drawings of all devices of a run (Simulation::drawDevices), by type.
class DeviceDrawings {
 public:
  explicit DeviceDrawings(DrawnRobots robots = {}) : robots_(std::move(robots)) {}

  /// Made when it is asked for first.
  DeviceDrawing& of(std::string_view type);
  const std::map<std::string, DeviceDrawing, std::less<>>& all() const { return drawings_; }
  void clear();

 private:
  DrawnRobots robots_;
  std::map<std::string, DeviceDrawing, std::less<>> drawings_;
};

}  // namespace swarmanoid
