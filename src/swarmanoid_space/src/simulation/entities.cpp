// Adding entities to a simulation and taking them out of it: decide first, then commit.
#include <algorithm>

#include "../assembly/assembly.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_interface/step_controller.hpp"
#include "swarmanoid_space/models/entity_type.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

[[noreturn]] void refuseStart(const ControllerDescription& controller, const std::string& robot,
                              const std::string& why) {
  throw ConfigError(controller.location,
                    "controller '" + controller.id + "' of '" + robot + "' does not start: " + why);
}

}  // namespace

void Simulation::refuseBadPlace(const EntityDescription& entity, const EntityModel& model, const Pose& pose,
                                const std::vector<Membership>& memberships) const {
  const std::vector<DeviceUse>& devices = devicesOf(assembly_->findGroup(entity.controller));
  for (const Membership& membership : memberships) {
    const std::string in_engine = "' in engine '" + membership.engine->id() + "': ";
    std::string problem = membership.engine->invalidPoseReason(model, pose);
    if (problem.empty() && membership.role == Role::kMove) {
      problem = unsupportedReasonOf(*membership.engine, model, devices, memberships);
    }
    if (!problem.empty()) {
      throw ConfigError(entity.location, entity.type + " '" + entity.id + in_engine + problem);
    }
    const Row other = membership.engine->overlap(model, pose, space_.entities.find(entity.id));
    if (other != kNoRow) {
      throw ConfigError(entity.location,
                        entity.type + " '" + entity.id + in_engine + "overlaps '" + space_.entities.name[other] + "'");
    }
  }
}

Row Simulation::addEntity(const EntityDescription& entity, const std::vector<Membership>& memberships) {
  if (space_.entities.find(entity.id) != kNoRow) {
    throw ConfigError(entity.location, "an entity '" + entity.id + "' exists already");
  }
  const auto type = makePlugin<EntityType>(*Registry::instance().find(PluginKind::kEntity, entity.type));
  const auto model = type->makeModel(entity.parameters);
  const Pose pose{entity.position, orientationFromAngles(entity.angles)};
  refuseBadPlace(entity, *model, pose, memberships);

  const Row row = space_.entities.add(entity.id, model, pose, entity.color);
  space_.placed[row] = space_.tick;
  try {
    if (!entity.controller.empty()) {
      giveController(row, entity);
    }
  } catch (...) {
    removeEntity(row);
    throw;
  }
  for (const Membership& membership : memberships) {
    callPlugin("add", assembly_->partOf(*membership.engine), UserCode::kNoTick,
               [&] { membership.engine->add(space_, row, membership.role); });
    assembly_->memberships[row].push_back(membership);
    if (membership.role == Role::kMove) {
      space_.mover[row] = membership.engine;
    }
  }
  if (memberships.empty()) {
    space_.entities_without_engine.push_back(row);
  }
  return row;
}

void Simulation::giveController(Row row, const EntityDescription& entity) {
  ControllerGroup* group = assembly_->findGroup(entity.controller);
  auto robot = std::make_unique<Robot>(entity.id, entity.type, space_.seed);
  robot->setLogSink(log_sink_);
  RobotInstance& instance = assembly_->robots.emplace_back();  // entity numbers only grow
  instance.row = row;
  instance.robot = robot.get();
  instance.group = group;
  instance.step = {"step", group->part, instance.robot->name()};
  instance.source = entity.source;
  instance.command_timeout = entity.command_timeout;
  space_.robots[row] = std::move(robot);
  space_.controllers[row] = {group->description, 1, StepStatus::kNothing};
  try {
    for (const auto& sensor : group->sensors) {
      instance.robot->provideSensor(sensor->type(), sensor->add(space_, row));
    }
    for (const auto& actuator : group->actuators) {
      instance.robot->provideActuator(actuator->type(), actuator->add(space_, row));
    }
    if (instance.source == CommandSource::kController) {
      instance.controller = startController(group->make, group->part, *instance.robot, group->description->parameters);
    }
    refuseUnlessReachable(instance, instance.source);
  } catch (const ConfigError& error) {
    if (!error.location().file.empty()) {
      throw;
    }
    refuseStart(*group->description, entity.id, describeException());
  } catch (...) {
    refuseStart(*group->description, entity.id, describeException());
  }
}

void Simulation::destroyController(RobotInstance& instance) {
  const std::string failure = endController(instance.controller, instance.group->part, *instance.robot);
  if (!failure.empty()) {
    failures_.push_back({instance.robot->name(), space_.tick, failure});
    pending_events_.push_back({Event::Kind::kControllerFailed, instance.robot->name(), "", failure});
    if (log_sink_) {
      log_sink_(LogLevel::kError, instance.robot->name(), "controller failed: " + failure);
    }
  }
}

void Simulation::destroyControllers() {
  for (RobotInstance& instance : assembly_->robots) {
    destroyController(instance);
  }
}

void Simulation::removeEntity(Row row) {
  if (RobotInstance* instance = assembly_->findRobot(space_.entities, row)) {
    destroyController(*instance);
    for (const auto& sensor : instance->group->sensors) {
      sensor->remove(space_, row);
    }
    for (const auto& actuator : instance->group->actuators) {
      actuator->remove(space_, row);
    }
    assembly_->robots.erase(assembly_->robots.begin() + (instance - assembly_->robots.data()));
  }
  space_.structure.isolate(row);
  space_.attachments.isolate(row);
  for (const Membership& membership : assembly_->memberships[row]) {
    callPlugin("remove", assembly_->partOf(*membership.engine), UserCode::kNoTick,
               [&] { membership.engine->remove(space_, row); });
  }
  auto& lone = space_.entities_without_engine;
  lone.erase(std::remove(lone.begin(), lone.end(), row), lone.end());
  space_.entities.remove(row);
}

void Simulation::unbuild() {
  for (RobotInstance& instance : assembly_->robots) {
    destroyController(instance);
  }
  assembly_->robots.clear();
  for (const auto& engine : assembly_->engines) {
    engine->clear();
  }
  assembly_->groups.clear();
  assembly_->triggers.clear();
  space_.attachments.clear();
  space_.entities.clear();
  space_.laser_spots.clear();
  space_.events.clear();
  space_.overflows.clear();
  space_.readings.clear();
  space_.commands.clear();
  space_.actuation.clear();
  space_.entities_without_engine.clear();
}

}  // namespace swarmanoid
