// Changes the source of a robot's commands: its controller here, a participant elsewhere, publishers on its topics, or
// none.
#include "../world/entities.hpp"
#include "../world/offers.hpp"
#include "carry_out.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_interface/step_controller.hpp"

namespace swarmanoid {

bool carryOut(World& world, const SetCommandSource& intervention) {
  const std::string& robot = intervention.robot;
  const CommandSource source = intervention.source;
  RobotInstance* instance = &requireRobot(world, robot);
  if (instance->source_when_charged.value_or(instance->source) == source) {
    return false;
  }
  std::shared_ptr<Controller> controller;
  const bool is_off = instance->source_when_charged.has_value();
  try {
    if (instance->has_failed && source != CommandSource::kNone) {
      throw std::runtime_error("it has failed, and stays stopped until a reset");
    }
    if (source == CommandSource::kController && !is_off) {
      controller = startControllerOf(*instance, world.space);
    }
    refuseUnlessReachable(*instance, source);
    refuseUnlessServed(world, source);
    if (source == CommandSource::kTopics && !world.supplied.commands->isOpen(robot)) {
      throw std::runtime_error("its devices have no topics; name it in ~device_topics");
    }
  } catch (...) {
    throw commandRefusal({}, robot, source, describeException());
  }
  if (is_off) {
    instance->source_when_charged = source;
    world.pending_events.push_back({Event::Kind::kIntervention, robot, "",
                                    std::string("commands from ") + toString(source) + " once its battery is charged"});
    return true;
  }
  destroyController(world, *instance);
  instance->controller = std::move(controller);
  ++world.space.controllers[instance->row].starts;
  world.pending_events.push_back(
      {Event::Kind::kIntervention, robot, "",
       std::string("commands from ") + toString(source) + ", no more from " + toString(instance->source)});
  const bool changes_offers = isOfOthers(source) || isOfOthers(instance->source);
  instance->source = source;
  instance->is_commanded = false;
  instance->stops_since.reset();
  if (source == CommandSource::kNone || source == CommandSource::kTopics) {
    instance->stops_since = world.space.time;
  }
  if (changes_offers) {
    offerRobots(world);
  }
  return true;
}

}  // namespace swarmanoid
