/// Device fields of robots with one Python controller each, in arrays with one row per robot. They are filled from the
/// run before a step and copied back after it, so Python code accesses only Python's memory: access is fast, and
/// references that it keeps stay valid.
///
/// Threads  the GIL must be held.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "moment.hpp"
#include "python/field_arrays.hpp"
#include "robots.hpp"

namespace swarmanoid::bindings {

class RobotHost {
 public:
  /// @param sensors, actuators types of devices, which all of the robots have
  /// @pre space and robots outlive the last step
  RobotHost(const Space& space, std::shared_ptr<const Moment> moment, std::shared_ptr<RobotSelection> robots,
            const std::vector<std::string>& sensors, const std::vector<std::string>& actuators);

  const RobotSelection& robots() const { return *robots_; }
  /// Begins a step: copies readings and commands of the run to the arrays.
  void begin();
  /// Ends a step: copies the arrays of commands to the run.
  void end();

  // For _single.py.
  /// A dictionary by device type of pairs: a dictionary of arrays by field name, and the names of the lists.
  pybind11::dict sensors() const { return dictionaryOf(sensors_); }
  pybind11::dict actuators() const { return dictionaryOf(actuators_); }
  /// In a step: the array of a robot's field that is written back at the end of the step, the same for each call, and
  /// read-only afterwards. Between steps: a read-only copy. @param row of one of the actuators' arrays
  pybind11::array handOut(const pybind11::array& row);
  bool isInStep() const { return step_.has_value(); }
  /// A list in a device of one robot in this step. @throws std::runtime_error between steps
  pybind11::object elements(const std::string& device, const std::string& list, std::size_t robot) const;
  std::string name(std::size_t robot) const { return at(robot).name(); }
  std::string type(std::size_t robot) const { return at(robot).type(); }
  double uniform(std::size_t robot, double low, double high) const { return at(robot).random().uniform(low, high); }
  double gaussian(std::size_t robot, double mean, double deviation) const {
    return at(robot).random().gaussian(mean, deviation);
  }
  void log(std::size_t robot, const std::string& text) const { at(robot).log(text); }
  void debug(std::size_t robot, const std::string& key, const std::string& value) const { at(robot).debug(key, value); }
  const Space& space() const {
    require();
    return *space_;
  }

 private:
  /// A device of all robots.
  struct Device {
    std::string type;
    const FieldTable* table = nullptr;
    Places places;
    std::vector<pybind11::array> arrays;  ///< in the order of the fields
  };

  static std::vector<Device> devicesOf(const Banks& banks, const RobotSelection& robots,
                                       const std::vector<std::string>& types);
  static pybind11::dict dictionaryOf(const std::vector<Device>& devices);
  void require() const;
  Robot& at(std::size_t robot) const {
    require();
    return *robots_->robots.at(robot);
  }

  const Space* space_;
  std::shared_ptr<const Moment> moment_;
  std::optional<OfMoment> step_;  // set during a step
  std::shared_ptr<RobotSelection> robots_;
  std::vector<Device> sensors_;
  std::vector<Device> actuators_;
  struct HandedOut {
    pybind11::array row;
    pybind11::array array;
  };
  std::unordered_map<const PyObject*, HandedOut> handed_out_;  // in this step, by row
};

void bindRobotHost(pybind11::module_& module);

}  // namespace swarmanoid::bindings
