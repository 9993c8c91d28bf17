/// A Python controller of all robots of a configuration: a function `step(robots)`, or an object with `step(robots)`
/// and optionally `init(parameters)`. See python_robots.hpp for controllers of single robots.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "moment.hpp"
#include "python/holds_objects.hpp"
#include "python/thrown.hpp"
#include "robots.hpp"
#include "swarmanoid_space/group_controller.hpp"

namespace swarmanoid::bindings {

class PythonController final : public GroupController, public HoldsObjects {
 public:
  /// @throws pybind11::type_error if the controller is neither
  PythonController(pybind11::object controller, std::shared_ptr<Moment> moment, std::shared_ptr<Thrown> thrown);

  // init and step acquire the GIL.
  void init(const Configuration& parameters) override;
  void start(const Space& space, Banks& commands, Row row, Robot& robot) override;
  /// A Python exception stops the robots. As in `init`, it is kept for the caller of the ticks.
  void step(const Space& space, Banks& commands, Span<const GroupMember> members) override;
  void archive(const Space& space, Banks& commands, StateArchive& state) override;

  int visitObjects(visitproc visit, void* argument) const override {
    return visitEach(visit, argument, controller_, step_);
  }
  void releaseObjects() override {
    controller_ = {};
    step_ = {};
  }

 private:
  pybind11::object controller_;
  pybind11::object step_;
  std::shared_ptr<Moment> moment_;
  std::shared_ptr<Thrown> thrown_;
  std::shared_ptr<RobotSelection> selection_;  // robots of the last step; null: to be selected again
};

/// Whether the robots of a selection are the members, in their order.
bool areSame(const RobotSelection& selection, Span<const GroupMember> members);
/// A selection of the members.
std::shared_ptr<RobotSelection> select(Span<const GroupMember> members);

}  // namespace swarmanoid::bindings
