// The source of a robot's commands: its controller here, a participant elsewhere, publishers on its topics, or none.
#include <set>

#include "../assembly/assembly.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_interface/step_controller.hpp"
#include "swarmanoid_space/lockstep/controller_frames.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

RemoteRobot describe(const RobotInstance& instance) {
  return describeRobot(*instance.robot, *instance.group->description);
}

}  // namespace

Lockstep& Simulation::lockstep() { return *lockstep_; }

void Simulation::interrupt() { lockstep_->cancel(); }

void Simulation::wake() { lockstep_->wake(); }

void Simulation::refuseUnlessReachable(const RobotInstance& instance, CommandSource source) const {
  if (source == CommandSource::kRemote || source == CommandSource::kTopics) {
    describe(instance);
  }
}

void Simulation::offerRobots() {
  std::vector<std::pair<RemoteRobot, std::size_t>> robots;
  for (std::size_t i = 0; i < assembly_->robots.size(); ++i) {
    if (assembly_->robots[i].source == CommandSource::kRemote) {
      robots.emplace_back(describe(assembly_->robots[i]), i);
    }
  }
  lockstep_->offer(robots, space_);
  if (supplied_.commands != nullptr) {
    std::set<std::string> commanded_by_topics;
    for (const RobotInstance& instance : assembly_->robots) {
      if (instance.source == CommandSource::kTopics) {
        commanded_by_topics.insert(instance.robot->name());
      }
    }
    supplied_.commands->accept(std::move(commanded_by_topics));
  }
}

void Simulation::setCommandSource(const std::string& robot, CommandSource source) {
  RobotInstance* instance = assembly_->findRobot(space_.entities, space_.entities.find(robot));
  if (instance == nullptr) {
    throw ConfigError({}, "there is no robot '" + robot + "' with a controller");
  }
  if (instance->source == source) {
    return;
  }
  std::shared_ptr<Controller> controller;
  try {
    if (source == CommandSource::kController) {
      controller = startController(instance->group->make, instance->group->part, *instance->robot,
                                   instance->group->description->parameters);
    }
    refuseUnlessReachable(*instance, source);
    if (source == CommandSource::kTopics && supplied_.commands == nullptr) {
      throw std::runtime_error("nobody listens to topics here, that needs ROS");
    }
    if (source == CommandSource::kTopics && !supplied_.commands->isOpen(robot)) {
      throw std::runtime_error("its devices have no topics; name it in ~device_topics");
    }
  } catch (...) {
    throw ConfigError({}, "'" + robot + "' cannot be commanded by " + toString(source) + ": " + describeException());
  }
  destroyController(*instance);
  instance->controller = std::move(controller);
  ++space_.controllers[instance->row].starts;
  pending_events_.push_back(
      {Event::Kind::kIntervention, robot, "",
       std::string("commands from ") + toString(source) + ", no more from " + toString(instance->source)});
  instance->source = source;
  instance->is_commanded = false;
  instance->stops_since.reset();
  if (source == CommandSource::kNone || source == CommandSource::kTopics) {
    instance->stops_since = space_.time;
  }
  offerRobots();
}

}  // namespace swarmanoid
