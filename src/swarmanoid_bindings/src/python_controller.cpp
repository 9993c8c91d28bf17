#include "python_controller.hpp"

#include <stdexcept>

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

/// An element's text, or the dictionary of its children.
py::object toPython(const Configuration& element) {
  if (element.children().empty()) {
    return py::str(element.text());
  }
  py::dict children;
  for (const Configuration& child : element.children()) {
    children[py::str(child.name())] = toPython(child);
  }
  return children;
}

/// For as long as a controller is called: what it may look at is not being changed.
class Pause {
 public:
  explicit Pause(Moment& moment) : moment_(moment) { moment_.is_ticking = false; }
  ~Pause() {
    moment_.is_ticking = true;
    ++moment_.number;  // the robots of a step are those of that step only
  }
  Pause(const Pause&) = delete;
  Pause& operator=(const Pause&) = delete;

 private:
  Moment& moment_;
};

}  // namespace

PythonController::PythonController(py::object controller, std::shared_ptr<Moment> moment,
                                   std::shared_ptr<Thrown> thrown)
    : controller_(std::move(controller)), moment_(std::move(moment)), thrown_(std::move(thrown)) {
  step_ = py::hasattr(controller_, "step") ? py::object(controller_.attr("step")) : controller_;
  if (PyCallable_Check(step_.ptr()) == 0) {
    throw py::type_error("found a controller " + std::string(py::repr(controller_)) +
                         ", allowed: a function of the robots, or an object with a function step(robots)");
  }
}

void PythonController::init(const Configuration& parameters) {
  if (py::hasattr(controller_, "init")) {
    const py::object given = toPython(parameters);
    controller_.attr("init")(py::isinstance<py::dict>(given) ? given : py::dict());
  }
}

void PythonController::step(const Space& space, Banks& /*commands*/, Span<const GroupMember> members) {
  const py::gil_scoped_acquire lock;
  if (thrown_->error) {
    return;  // the tick is the last one until somebody has seen what another controller threw
  }
  const Pause pause(*moment_);
  try {
    step_(SteppedRobots(space, moment_, members));
  } catch (py::error_already_set& error) {
    const std::string what = error.what();
    const bool is_of_user = error.matches(PyExc_Exception);  // Ctrl-C is not
    thrown_->error.emplace(std::move(error));
    if (is_of_user) {
      throw std::runtime_error(what);
    }
  }
}

}  // namespace swarmanoid::bindings
