/// A controller in Python of all robots of a configuration: a function `step(robots)`, or an object with `step(robots)`
/// and, if it likes, `init(parameters)`.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "moment.hpp"
#include "run.hpp"
#include "swarmanoid_space/group_controller.hpp"

namespace swarmanoid::bindings {

class PythonController final : public GroupController {
 public:
  /// @throws pybind11::type_error if it is neither
  PythonController(pybind11::object controller, std::shared_ptr<Moment> moment, std::shared_ptr<Thrown> thrown);

  /// @pre Python's lock is held
  void init(const Configuration& parameters) override;
  /// Takes Python's lock. What Python throws stops the robots, and is kept for whoever makes the ticks.
  void step(const Space& space, Banks& commands, Span<const GroupMember> members) override;

 private:
  pybind11::object controller_;
  pybind11::object step_;
  std::shared_ptr<Moment> moment_;
  std::shared_ptr<Thrown> thrown_;
};

}  // namespace swarmanoid::bindings
