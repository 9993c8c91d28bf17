/// Drawings of devices for viewers: rays, fields of view, links between robots, as coloured lines and points in W [m].
///
/// A device draws (`drawOne` of SensorOf and ActuatorOf) only if a viewer is active, in `show` or between ticks.
/// Engines have moved since the device sensed, so rays, messages and other contents of the space are drawn at the
/// current poses. Colours and lengths that stand for readings are those that the robot's controller got in this tick,
/// with all errors. Drawing does not change results.
///
/// The viewer chooses the robots whose devices are drawn (DrawnRobots); a device draws these robots only.
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
  std::vector<std::string> names;  ///< used unless is_all: names, or prefixes of names followed by *

  bool has(std::string_view robot) const;
};

/// @param words names, prefixes followed by *, or "all" alone; an empty list means "all"
/// @throws ConfigError for a word that matches no robot of the experiment; the message begins with the parameter's name
DrawnRobots chooseDrawnRobots(const std::vector<std::string>& words, const std::string& parameter,
                              const Experiment& experiment);

/// The drawing of all devices of one type. `clear` keeps its memory.
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

  /// Whether the devices of a robot are drawn; checked before `drawOne`.
  bool isOf(std::string_view robot) const { return robots_.has(robot); }

  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Color color);
  void point(const Eigen::Vector3d& place, Color color);
  /// The head has two strokes, each a fifth of the arrow's length, in the vertical plane of the arrow.
  void arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Color color);
  /// The points centre + cos(t) * a + sin(t) * b from t = first to last [rad], in straight pieces of up to 15 degrees.
  void arc(const Eigen::Vector3d& centre, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double first, double last,
           Color color);
  /// A full turn of the same arc.
  void circle(const Eigen::Vector3d& centre, const Eigen::Vector3d& a, const Eigen::Vector3d& b, Color color);
  /// The same circle, and four lines from it to the tip.
  void cone(const Eigen::Vector3d& tip, const Eigen::Vector3d& centre, const Eigen::Vector3d& a,
            const Eigen::Vector3d& b, Color color);

  const std::vector<Line>& lines() const { return lines_; }
  const std::vector<Point>& points() const { return points_; }
  /// Whether anything was ever drawn; displays omit device types that never draw.
  bool isUsed() const { return is_used_; }
  void clear();

  static constexpr Color kOutline{120, 130, 150};  ///< colour of fields of view
  /// Colour for a reading from 0 (a bluish grey) to 1 (red).
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

  /// Created on first use.
  DeviceDrawing& of(std::string_view type);
  const std::map<std::string, DeviceDrawing, std::less<>>& all() const { return drawings_; }
  void clear();

 private:
  DrawnRobots robots_;
  std::map<std::string, DeviceDrawing, std::less<>> drawings_;
};

}  // namespace swarmanoid
