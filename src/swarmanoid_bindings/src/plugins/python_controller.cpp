#include "python_controller.hpp"

#include <algorithm>
#include <stdexcept>

#include "python/archive_object.hpp"
#include "python/errors.hpp"
#include "python/python_lock.hpp"
#include "python/python_parameters.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {

bool areSame(const RobotSelection& selection, Span<const GroupMember> members) {
  if (selection.rows.size() != members.size()) {
    return false;
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (selection.rows[i] != members[i].row || selection.robots[i] != members[i].robot) {
      return false;
    }
  }
  return true;
}

std::shared_ptr<RobotSelection> select(Span<const GroupMember> members) {
  auto selection = std::make_shared<RobotSelection>();
  for (const GroupMember& member : members) {
    selection->rows.push_back(member.row);
    selection->robots.push_back(member.robot);
  }
  return selection;
}

PythonController::PythonController(py::object controller, std::shared_ptr<Moment> moment,
                                   std::shared_ptr<Thrown> thrown)
    : controller_(std::move(controller)), moment_(std::move(moment)), thrown_(std::move(thrown)) {
  step_ = py::hasattr(controller_, "step") ? py::object(controller_.attr("step")) : controller_;
  if (PyCallable_Check(step_.ptr()) == 0) {
    throw py::type_error("found a controller " + std::string(py::repr(controller_)) +
                         ", allowed: a function of the robots, an object with a function step(robots), or a class "
                         "with a function step(self, robot)");
  }
}

void PythonController::init(const Configuration& parameters) {
  const PythonLock lock;
  selection_ = nullptr;
  try {
    if (py::hasattr(controller_, "init")) {
      controller_.attr("init")(parametersOf(parameters));
    }
  } catch (py::error_already_set& error) {
    const std::string what = describe(error);
    thrown_->keep(std::move(error));
    throw std::runtime_error(what);
  }
}

void PythonController::start(const Space& /*space*/, Banks& /*commands*/, Row /*row*/, Robot& /*robot*/) {
  selection_ = nullptr;  // a new robot may reuse the row of a deleted one
}

void PythonController::step(const Space& space, Banks& /*commands*/, Span<const GroupMember> members) {
  const PythonLock lock;
  if (thrown_->isOver()) {
    return;
  }
  if (selection_ == nullptr || !areSame(*selection_, members)) {
    selection_ = select(members);
  }
  const Pause pause(*moment_);
  try {
    const py::object robots = py::cast(SteppedRobots(space, moment_, selection_));
    step_(robots);
    robots.cast<SteppedRobots&>().commands().writeBack();
  } catch (py::error_already_set& error) {
    const std::string what = describe(error);
    if (thrown_->keep(std::move(error))) {
      throw std::runtime_error(what);
    }
  }
}

void PythonController::archive(const Space& /*space*/, Banks& /*commands*/, StateArchive& state) {
  const PythonLock lock;
  archiveObject(state, controller_);
}

}  // namespace swarmanoid::bindings
