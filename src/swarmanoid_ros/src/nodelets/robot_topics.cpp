#include "robot_topics.hpp"

#include <ros/console.h>
#include <ros/init.h>

#include <stdexcept>

namespace swarmanoid {

RobotTopics::RobotTopics(std::string space, Selection selection, NodeletLoader& loader, AttachmentPoint& point,
                         std::shared_ptr<CommandMailbox> commands)
    : space_(std::move(space)),
      selection_(std::move(selection)),
      loader_(loader),
      point_(point),
      commands_(std::move(commands)) {
  id_ = "robot_topics";
}

RobotTopics::~RobotTopics() { stop(); }

void RobotTopics::adopt(const std::vector<AttachmentPoint::Request>& parts) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const AttachmentPoint::Request& part : parts) {
    if (part.kind == PluginKind::kObserver) {
      topics_[part.id] = std::static_pointer_cast<Observer>(point_.part(part.kind, part.id));
      served_[part.id] = kNoEntity;  // its number is read from the space later
    }
  }
}

void RobotTopics::start(SimulationThread& thread) {
  simulation_ = &thread;
  worker_ = std::thread([this] { work(); });
}

void RobotTopics::stop() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  wake_.notify_all();
  if (worker_.joinable()) {
    worker_.join();
  }
}

void RobotTopics::follow(const Space& space) {
  if (!changes_.look(space)) {
    return;
  }
  Robots present;
  for (const Row row : space.entities.order) {
    const bool is_robot = space.controllers[row].description != nullptr;
    const std::string& name = space.entities.name[row];
    if ((selection_.is_all && is_robot) || selection_.names.count(name) > 0) {
      present[name] = space.entities.number[row];
    }
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (auto& [robot, number] : served_) {
      if (number == kNoEntity && present.count(robot) > 0) {
        number = present[robot];
      }
    }
    wanted_ = std::move(present);
  }
  wake_.notify_all();
}

void RobotTopics::draw(const Space& space) {
  follow(space);
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [robot, topics] : topics_) {
    topics->draw(space);
  }
}

std::string RobotTopics::difference() const {
  for (const auto& [robot, number] : served_) {
    const auto found = wanted_.find(robot);
    if (found == wanted_.end() || found->second != number) {
      return robot;
    }
  }
  for (const auto& [robot, number] : wanted_) {
    if (served_.count(robot) == 0) {
      return robot;
    }
  }
  return "";
}

void RobotTopics::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return is_over_ || !difference().empty(); });
    if (is_over_) {
      return;
    }
    const std::string robot = difference();
    if (served_.erase(robot) > 0) {
      topics_.erase(robot);
      lock.unlock();
      unload(robot);
    } else {
      served_[robot] = wanted_[robot];
      lock.unlock();
      load(robot);
    }
    lock.lock();
  }
}

void RobotTopics::load(const std::string& robot) {
  const AttachmentPoint::Request part = deviceTopicsOf(robot, commands_);
  point_.expect(part);
  if (!loadPart(loader_, space_, part)) {
    if (ros::ok()) {
      ROS_ERROR("%s: found no topics for the devices of '%s': its nodelet does not load", space_.c_str(),
                robot.c_str());
    }
    return;
  }
  const auto topics = std::static_pointer_cast<Observer>(point_.part(part.kind, part.id));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    topics_[robot] = topics;
  }
  try {
    // a paused space makes no ticks, so the topics are published here for the client that has spawned the robot
    simulation_->look([&topics](const Simulation& simulation) { topics->draw(simulation.space()); });
  } catch (const std::exception&) {
    // the run was stopped meanwhile
  }
}

void RobotTopics::unload(const std::string& robot) {
  const AttachmentPoint::Request part = deviceTopicsOf(robot, commands_);
  loader_.unload(nodeletName(space_, part));
  point_.forget(part.kind, part.id);
}

}  // namespace swarmanoid
