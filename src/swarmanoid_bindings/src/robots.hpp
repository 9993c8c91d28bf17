/// Robots of a run in Python, in the order of their entity numbers: names, poses, readings and commands as arrays with
/// one row per robot. Arrays are read-only copies, except commands in a step (field_arrays.hpp) and drawn numbers,
/// which belong to the caller.
///
/// Units    SI, radians; frame W.
/// Threads  the GIL must be held. Valid only in the moment of creation (moment.hpp).
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "moment.hpp"
#include "python/field_arrays.hpp"
#include "swarmanoid_interface/robot.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid::bindings {

/// Robots and the addresses of their devices. Reused while the same robots keep the same devices.
struct RobotSelection {
  std::vector<Row> rows;
  std::vector<Robot*> robots;              ///< only for stepped robots
  std::map<std::string, Places> readings;  ///< by type, of the robots that have the device
  std::map<std::string, Places> commands;
};

/// Sensors or actuators of the robots, by type: robots.readings["footbot_proximity"].
class Devices {
 public:
  /// @param banks must outlive the moment
  Devices(OfMoment moment, const Banks& banks, std::shared_ptr<const std::vector<Row>> rows,
          std::map<std::string, Places>& places, ArrayUse use)
      : moment_(std::move(moment)), banks_(&banks), rows_(std::move(rows)), places_(&places), use_(use) {}

  /// Fields of a device type, for the robots that have it. @throws pybind11::key_error if none has it
  const FieldArrays& at(const std::string& type);
  bool has(const std::string& type) const;
  std::vector<std::string> types() const;
  void writeBack() const;
  /// Indices of the robots that have such a device.
  pybind11::array_t<std::int64_t> owners(const std::string& type) const;

 private:
  Places placesOf(const std::string& type);

  OfMoment moment_;
  const Banks* banks_;
  std::shared_ptr<const std::vector<Row>> rows_;  // shares ownership of the selection
  std::map<std::string, Places>* places_;         // points into the selection
  ArrayUse use_;
  std::map<std::string, FieldArrays> known_;
};

/// Robots of a run, read-only.
class Robots {
 public:
  Robots(const Space& space, std::shared_ptr<const Moment> moment, std::vector<Row> rows);
  /// The same of a selection, whose addresses of devices are used again.
  Robots(const Space& space, std::shared_ptr<const Moment> moment, std::shared_ptr<RobotSelection> selection)
      : Robots(space, std::move(moment), std::move(selection), ArrayUse::kLook) {}

  std::size_t size() const { return rows().size(); }
  std::vector<std::string> names() const;
  std::vector<std::string> types() const;
  /// The id of the controller configuration of each robot, or "".
  std::vector<std::string> controllers() const;
  /// Entity numbers, ascending and never reused: (robots,).
  pybind11::array_t<std::int64_t> numbers() const;
  /// A read-only subset. @param places indices into these robots @throws pybind11::index_error
  Robots take(const std::vector<std::size_t>& places) const;
  /// Position x, y, z and quaternion x, y, z, w: (robots, 7).
  pybind11::array_t<double> poses() const;
  /// Linear velocity, then angular velocity: (robots, 6).
  pybind11::array_t<double> twists() const;
  /// Values of a property, NaN for robots without it: (robots,).
  pybind11::array_t<double> property(const std::string& name) const;
  Devices& readings() { return readings_; }
  Devices& commands() { return commands_; }

 protected:
  Robots(const Space& space, std::shared_ptr<const Moment> moment, std::shared_ptr<RobotSelection> selection,
         ArrayUse use_of_commands);
  const std::vector<Row>& rows() const { return selection_->rows; }
  const std::vector<Robot*>& robots() const { return selection_->robots; }
  const Space& space() const {
    moment_.require();
    return *space_;
  }

 private:
  const Space* space_;
  std::shared_ptr<const Moment> whole_moment_;
  OfMoment moment_;
  std::shared_ptr<RobotSelection> selection_;
  Devices readings_;
  Devices commands_;
};

/// The robots of a space, by entity number.
Robots robotsOf(const Space& space, std::shared_ptr<const Moment> moment);
/// All entities.
Robots entitiesOf(const Space& space, std::shared_ptr<const Moment> moment);

/// The robots in the current step of a controller: their commands are writable, and they have random numbers and a log.
class SteppedRobots : public Robots {
 public:
  SteppedRobots(const Space& space, std::shared_ptr<const Moment> moment, std::shared_ptr<RobotSelection> selection)
      : Robots(space, std::move(moment), std::move(selection), ArrayUse::kWrite) {}

  std::uint64_t tick() const { return space().tick; }
  double time() const { return toSeconds(space().time - kEpoch); }
  double dt() const { return toSeconds(space().clocktick); }
  /// The next number of each robot's own stream (Robot::random), the same as for a C++ controller.
  pybind11::array_t<double> uniform(double low, double high) const;
  pybind11::array_t<double> gaussian(double mean, double standard_deviation) const;
  void log(std::size_t robot, const std::string& text) const;
  void debug(std::size_t robot, const std::string& key, const std::string& value) const;

 private:
  Robot& at(std::size_t robot) const;
};

void bindRobots(pybind11::module_& module);

}  // namespace swarmanoid::bindings
