#include "offers.hpp"

#include <set>
#include <stdexcept>

#include "swarmanoid_space/lockstep/controller_frames.hpp"

namespace swarmanoid {
namespace {

RemoteRobot describe(const RobotInstance& instance) {
  return describeRobot(*instance.robot, *instance.group->description);
}

}  // namespace

void refuseUnlessReachable(const RobotInstance& instance, CommandSource source) {
  if (isOfOthers(source)) {
    describe(instance);
  }
}

void refuseUnlessServed(const World& world, CommandSource source) {
  if (source == CommandSource::kRemote && !world.context.is_open) {
    throw std::runtime_error("no process elsewhere can answer here, that needs ROS");
  }
  if (source == CommandSource::kTopics && world.supplied.commands == nullptr) {
    throw std::runtime_error("nobody listens to topics here, that needs ROS");
  }
}

ConfigError commandRefusal(const SourceLocation& location, const std::string& robot, CommandSource source,
                           const std::string& why) {
  return {location, "'" + robot + "' cannot be commanded by " + toString(source) + ": " + why};
}

void offerRobots(World& world) {
  std::vector<std::pair<RemoteRobot, std::size_t>> robots;
  for (std::size_t i = 0; i < world.assembly.robots.size(); ++i) {
    if (world.assembly.robots[i].source == CommandSource::kRemote) {
      robots.emplace_back(describe(world.assembly.robots[i]), i);
    }
  }
  world.lockstep.offer(robots, world.space);
  if (world.supplied.commands != nullptr) {
    std::set<std::string> commanded_by_topics;
    for (const RobotInstance& instance : world.assembly.robots) {
      if (instance.source == CommandSource::kTopics) {
        commanded_by_topics.insert(instance.robot->name());
      }
    }
    world.supplied.commands->accept(std::move(commanded_by_topics));
  }
}

}  // namespace swarmanoid
