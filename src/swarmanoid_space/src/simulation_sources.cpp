// Who commands a robot: its controller here, a participant elsewhere, or nobody.
#include "cast.hpp"
#include "swarmanoid_space/controller_frames.hpp"
#include "swarmanoid_space/simulation.hpp"

namespace swarmanoid {
namespace {

RemoteRobot describe(const Driver& driver) { return describeRobot(*driver.robot, *driver.group->description); }

}  // namespace

const char* toString(CommandSource source) {
  switch (source) {
    case CommandSource::kController:
      return "controller";
    case CommandSource::kRemote:
      return "remote";
    case CommandSource::kNone:
      return "none";
  }
  return "";
}

std::optional<CommandSource> parseCommandSource(const std::string& text) {
  for (const CommandSource source : {CommandSource::kController, CommandSource::kRemote, CommandSource::kNone}) {
    if (text == toString(source)) {
      return source;
    }
  }
  return std::nullopt;
}

Lockstep& Simulation::lockstep() { return cast_->lockstep; }

void Simulation::interrupt() { cast_->lockstep.cancel(); }

void Simulation::refuseUnlessRemote(const Driver& driver) const { describe(driver); }

void Simulation::offerRobots() {
  std::vector<std::pair<RemoteRobot, std::size_t>> robots;
  for (std::size_t i = 0; i < cast_->drivers.size(); ++i) {
    if (cast_->drivers[i].source == CommandSource::kRemote) {
      robots.emplace_back(describe(cast_->drivers[i]), i);
    }
  }
  cast_->lockstep.offer(robots, space_);
}

void Simulation::setCommandSource(const std::string& robot, CommandSource source) {
  Driver* driver = cast_->findDriver(space_.entities.find(robot));
  if (driver == nullptr) {
    throw ConfigError({}, "there is no robot '" + robot + "' with a controller");
  }
  if (driver->source == source) {
    return;
  }
  std::shared_ptr<Controller> controller;
  try {
    if (source == CommandSource::kController) {
      controller = driver->group->make();
      controller->init(*driver->robot, driver->group->description->parameters);
    } else if (source == CommandSource::kRemote) {
      refuseUnlessRemote(*driver);
    }
  } catch (const std::exception& error) {
    throw ConfigError({}, "'" + robot + "' cannot be commanded by " + toString(source) + ": " + error.what());
  }
  if (driver->controller) {
    driver->controller->destroy();
  }
  driver->controller = std::move(controller);
  ++space_.controllers[static_cast<std::size_t>(driver->row)].starts;
  pending_events_.push_back(
      {Event::Kind::kIntervention, robot, "",
       std::string("commands from ") + toString(source) + ", no more from " + toString(driver->source)});
  driver->source = source;
  if (source == CommandSource::kNone) {
    for (const auto& actuator : driver->group->actuators) {
      actuator->stop(space_, driver->row);
    }
  }
  offerRobots();
}

}  // namespace swarmanoid
