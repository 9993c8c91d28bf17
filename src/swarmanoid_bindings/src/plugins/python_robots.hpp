/// Python controllers, one per robot of a configuration: a class with `step(self, robot)` and optionally
/// `init(self, robot, parameters)`. They are stepped one after the other, by entity number, so runs are reproducible
/// even if controllers share data.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "moment.hpp"
#include "python/holds_objects.hpp"
#include "python/thrown.hpp"
#include "robot_host.hpp"
#include "swarmanoid_space/group_controller.hpp"

namespace swarmanoid::bindings {

class PythonRobots final : public GroupController, public HoldsObjects {
 public:
  /// @param type the class @param description of the configuration
  /// @throws pybind11::type_error if the class has no step
  PythonRobots(pybind11::object type, const ControllerDescription& description, std::shared_ptr<Moment> moment,
               std::shared_ptr<Thrown> thrown);

  void init(const Configuration& parameters) override;
  /// Creates the robot's controller. Acquires the GIL, as step does.
  /// @throws std::runtime_error with the text of a Python exception
  void start(const Space& space, Banks& commands, Row row, Robot& robot) override;
  /// A Python exception stops that robot, and is kept for the caller of the ticks.
  void step(const Space& space, Banks& commands, Span<const GroupMember> members) override;
  void archive(const Space& space, Banks& commands, StateArchive& state) override;

  int visitObjects(visitproc visit, void* argument) const override;
  void releaseObjects() override;

 private:
  struct Instance {
    pybind11::object robot;
    pybind11::object step;  ///< bound to the controller
  };

  std::shared_ptr<RobotHost> hostOf(const Space& space, Span<const GroupMember> members) const;
  void regroup(const Space& space, Span<const GroupMember> members);

  pybind11::object type_;
  std::vector<std::string> sensors_;
  std::vector<std::string> actuators_;
  std::shared_ptr<Moment> moment_;
  std::shared_ptr<Thrown> thrown_;
  pybind11::dict parameters_;
  std::unordered_map<const Robot*, Instance> instances_;
  std::shared_ptr<RobotHost> host_;  // of the robots stepped last; null: to be created again
  std::vector<Instance> stepped_;    // controllers stepped last, in their order
};

}  // namespace swarmanoid::bindings
