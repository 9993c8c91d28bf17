#include "python_robots.hpp"

#include <stdexcept>
#include <utility>

#include "python/archive_object.hpp"
#include "python/errors.hpp"
#include "python/python_lock.hpp"
#include "python/python_parameters.hpp"
#include "python_controller.hpp"

namespace py = pybind11;

namespace swarmanoid::bindings {
namespace {

std::vector<std::string> typesOf(const std::vector<DeviceDescription>& devices) {
  std::vector<std::string> types;
  for (const DeviceDescription& device : devices) {
    types.push_back(device.type);
  }
  return types;
}

}  // namespace

PythonRobots::PythonRobots(py::object type, const ControllerDescription& description, std::shared_ptr<Moment> moment,
                           std::shared_ptr<Thrown> thrown)
    : type_(std::move(type)),
      sensors_(typesOf(description.sensors)),
      actuators_(typesOf(description.actuators)),
      moment_(std::move(moment)),
      thrown_(std::move(thrown)) {
  if (!py::hasattr(type_, "step")) {
    throw py::type_error("found a controller " + std::string(py::repr(type_)) +
                         ", allowed: a class with a function step(self, robot)");
  }
}

void PythonRobots::init(const Configuration& parameters) {
  const PythonLock lock;
  parameters_ = parametersOf(parameters);
  instances_.clear();
  stepped_.clear();
  host_ = nullptr;
}

std::shared_ptr<RobotHost> PythonRobots::hostOf(const Space& space, Span<const GroupMember> members) const {
  return std::make_shared<RobotHost>(space, moment_, select(members), sensors_, actuators_);
}

void PythonRobots::start(const Space& space, Banks& /*commands*/, Row row, Robot& robot) {
  const PythonLock lock;
  host_ = nullptr;
  const GroupMember member{row, &robot, nullptr};
  const Pause pause(*moment_);
  const auto host = hostOf(space, {&member, 1});
  host->begin();
  try {
    const py::object made = py::module_::import("swarmanoid._single").attr("Robot")(host);
    const py::object controller = type_();
    if (py::hasattr(controller, "init")) {
      controller.attr("init")(made, parameters_);
    }
    instances_[&robot] = {made, controller.attr("step")};
  } catch (py::error_already_set& error) {
    host->end();
    const std::string what = describe(error);
    if (thrown_->isInterruption(error)) {
      thrown_->keep(std::move(error));
    }
    throw std::runtime_error(what);
  }
  host->end();
}

void PythonRobots::regroup(const Space& space, Span<const GroupMember> members) {
  host_ = hostOf(space, members);
  stepped_.clear();
  std::unordered_map<const Robot*, Instance>
      kept;  // drops controllers of absent robots: a robot that returns gets a new one
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Instance& instance = instances_.at(members[i].robot);
    instance.robot.attr("_bind")(host_, i);
    stepped_.push_back(instance);
    kept.emplace(members[i].robot, instance);
  }
  instances_ = std::move(kept);
}

int PythonRobots::visitObjects(visitproc visit, void* argument) const {
  int result = visitEach(visit, argument, type_, parameters_);
  for (auto known = instances_.begin(); result == 0 && known != instances_.end(); ++known) {
    result = visitEach(visit, argument, known->second.robot, known->second.step);
  }
  for (auto stepped = stepped_.begin(); result == 0 && stepped != stepped_.end(); ++stepped) {
    result = visitEach(visit, argument, stepped->robot, stepped->step);
  }
  return result;
}

void PythonRobots::releaseObjects() {
  instances_.clear();
  stepped_.clear();
  host_ = nullptr;
  parameters_ = {};
  type_ = {};
}

void PythonRobots::archive(const Space& space, Banks& /*commands*/, StateArchive& state) {
  const PythonLock lock;
  for (const Row row : space.entities.order) {
    const auto found = instances_.find(space.robots[row].get());
    if (found != instances_.end()) {
      archiveObject(state, found->second.step);
    }
  }
}

void PythonRobots::step(const Space& space, Banks& /*commands*/, Span<const GroupMember> members) {
  const PythonLock lock;
  if (thrown_->isOver()) {
    return;
  }
  if (host_ == nullptr || !areSame(host_->robots(), members)) {
    regroup(space, members);
  }
  const Pause pause(*moment_);
  host_->begin();
  for (std::size_t i = 0; i < members.size(); ++i) {
    try {
      stepped_[i].step(stepped_[i].robot);
    } catch (py::error_already_set& error) {
      const std::string what = describe(error);
      if (!thrown_->keep(std::move(error))) {
        break;
      }
      *members[i].failure = what;
    }
  }
  host_->end();
}

}  // namespace swarmanoid::bindings
