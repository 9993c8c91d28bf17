#include "entities.hpp"

#include <algorithm>

#include "../assembly/find_overlap.hpp"
#include "offers.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_interface/step_controller.hpp"
#include "swarmanoid_space/models/entity_type.hpp"
#include "swarmanoid_space/power_demand.hpp"

namespace swarmanoid {
namespace {

[[noreturn]] void refuseStart(const ControllerDescription& controller, const std::string& robot,
                              const std::string& why) {
  throw ConfigError(controller.location,
                    "controller '" + controller.id + "' of '" + robot + "' does not start: " + why);
}

void giveController(World& world, Row row, const EntityDescription& entity) {
  ControllerGroup* group = world.assembly.findGroup(entity.controller);
  auto robot = std::make_unique<Robot>(entity.id, entity.type, world.space.seed);
  robot->setLogSink(world.log_sink);
  RobotInstance& instance = world.assembly.robots.emplace_back();  // entity numbers only grow
  instance.row = row;
  instance.robot = robot.get();
  instance.group = group;
  instance.step = {"step", group->part, instance.robot->name()};
  instance.source = entity.source;
  instance.command_timeout = entity.command_timeout;
  world.space.robots[row] = std::move(robot);
  world.space.controllers[row] = {group->description, 1, StepStatus::kNothing};
  try {
    for (const auto& sensor : group->sensors) {
      instance.robot->provideSensor(sensor->type(), sensor->add(world.space, row));
    }
    for (const auto& actuator : group->actuators) {
      instance.robot->provideActuator(actuator->type(), actuator->add(world.space, row));
    }
    if (instance.source == CommandSource::kController) {
      instance.controller = startControllerOf(instance, world.space);
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

void giveBattery(World& world, Row row, const EntityDescription& entity) {
  const ControllerGroup* group = world.assembly.findGroup(entity.controller);
  world.space.batteries[row][0].standby =
      standbyPower(*world.space.entities.model[row]->battery, group == nullptr ? nullptr : group->description);
  world.space.powered.push_back(row);  // entity numbers only grow
}

[[noreturn]] void refuseIn(const Engine& engine, const EntityDescription& entity, const std::string& problem) {
  throw ConfigError(entity.location, entity.type + " '" + entity.id + "' in engine '" + engine.id() + "': " + problem);
}

void refuseTaken(const World& world, const EntityDescription& entity) {
  if (world.space.entities.find(entity.id) != kNoRow) {
    throw ConfigError(entity.location, "an entity '" + entity.id + "' exists already");
  }
}

/// @param membership one of `memberships` @throws ConfigError if its engine cannot have the entity at that pose
void refuseUnsupported(const World& world, const EntityDescription& entity, const EntityModel& model, const Pose& pose,
                       const std::vector<Membership>& memberships, const Membership& membership) {
  std::string problem = membership.engine->invalidPoseReason(model, pose);
  if (problem.empty() && membership.role == Role::kMove) {
    const std::vector<DeviceUse>& devices = devicesOf(world.assembly.findGroup(entity.controller));
    problem = unsupportedReasonOf(*membership.engine, model, devices, memberships);
  }
  if (!problem.empty()) {
    refuseIn(*membership.engine, entity, problem);
  }
}

/// Gives a new entity its battery, its devices and controller, and its place in engines.
void furnish(World& world, Row row, const EntityDescription& entity, const std::vector<Membership>& memberships) {
  world.space.placed[row] = world.space.tick;
  if (world.space.entities.model[row]->battery) {
    giveBattery(world, row, entity);
  }
  if (!entity.controller.empty()) {
    giveController(world, row, entity);
  }
  // set first, because engines treat a mirror differently depending on whether an engine moves the entity
  for (const Membership& membership : memberships) {
    if (membership.role == Role::kMove) {
      world.space.mover[row] = membership.engine;
    }
  }
  for (const Membership& membership : memberships) {
    callPlugin("add", partOf(world.assembly.engines, *membership.engine), UserCode::kNoTick,
               [&] { membership.engine->add(world.space, row, membership.role); });
    world.assembly.memberships[row].push_back(membership);
  }
  if (memberships.empty()) {
    world.space.entities_without_engine.place(world.space.entities, row);
  }
}

/// Adds an entity after all checks. @throws ConfigError if its controller does not start; then nothing has changed
Row add(World& world, const EntityDescription& entity, const std::shared_ptr<const EntityModel>& model,
        const std::vector<Membership>& memberships) {
  const Row row = world.space.entities.add(entity.id, model, poseOf(entity), entity.color);
  try {
    furnish(world, row, entity, memberships);
  } catch (...) {
    removeEntity(world, row);
    world.space.entities.giveBackLastNumber();  // state hashes of later entities depend on their numbers
    throw;
  }
  return row;
}

}  // namespace

void refuseBadPlace(const World& world, const EntityDescription& entity, const EntityModel& model, const Pose& pose,
                    const std::vector<Membership>& memberships, Span<const Row> ignored) {
  for (const Membership& membership : memberships) {
    refuseUnsupported(world, entity, model, pose, memberships, membership);
    // fixed entities may overlap each other: walls meet in their corners
    const auto counts = [&](Row other) { return model.is_movable || world.space.entities.model[other]->is_movable; };
    const Row other = findOverlap(*membership.engine, model, pose, {ignored.begin(), ignored.end()}, counts);
    if (other != kNoRow) {
      refuseIn(*membership.engine, entity, "overlaps '" + world.space.entities.name[other] + "'");
    }
  }
}

std::shared_ptr<const EntityModel> modelOf(const EntityDescription& entity) {
  const auto type = makePlugin<EntityType>(*Registry::instance().find(PluginKind::kEntity, entity.type));
  return type->makeModel(entity.parameters);
}

Row addEntity(World& world, const EntityDescription& entity, const std::vector<Membership>& memberships) {
  refuseTaken(world, entity);
  const auto model = modelOf(entity);
  refuseBadPlace(world, entity, *model, poseOf(entity), memberships, {});
  return add(world, entity, model, memberships);
}

Row addFreeEntity(World& world, const EntityDescription& entity, const std::shared_ptr<const EntityModel>& model,
                  const std::vector<Membership>& memberships) {
  refuseTaken(world, entity);
  for (const Membership& membership : memberships) {
    refuseUnsupported(world, entity, *model, poseOf(entity), memberships, membership);
  }
  return add(world, entity, model, memberships);
}

void addEntityAt(World& world, Row row, EntityNumber number, const EntityDescription& entity,
                 const std::shared_ptr<const EntityModel>& model, const Pose& pose,
                 const std::vector<Membership>& memberships) {
  world.space.entities.addAt(row, number, entity.id, model, pose, entity.color);
  furnish(world, row, entity, memberships);
}

void destroyController(World& world, RobotInstance& instance) {
  const std::string failure = endController(instance.controller, instance.group->part, *instance.robot);
  if (!failure.empty()) {
    world.failures.push_back({instance.robot->name(), world.space.tick, failure});
    world.pending_events.push_back({Event::Kind::kControllerFailed, instance.robot->name(), "", failure});
    if (world.log_sink) {
      world.log_sink(LogLevel::kError, instance.robot->name(), "controller failed: " + failure);
    }
  }
}

void setPose(World& world, Row row, const Pose& pose) {
  world.space.entities.pose[row] = pose;
  world.space.entities.twist[row] = Twist{};
  world.space.placed[row] = world.space.tick;
  for (const Membership& membership : world.assembly.memberships[row]) {
    callPlugin("place", partOf(world.assembly.engines, *membership.engine), UserCode::kNoTick,
               [&] { membership.engine->place(world.space, row); });
  }
  if (world.space.entities_without_engine.has(row)) {
    world.space.entities_without_engine.place(world.space.entities, row);
  }
}

void removeEntity(World& world, Row row) {
  if (RobotInstance* instance = world.assembly.findRobot(world.space.entities, row)) {
    destroyController(world, *instance);
    for (const auto& sensor : instance->group->sensors) {
      sensor->remove(world.space, row);
    }
    for (const auto& actuator : instance->group->actuators) {
      actuator->remove(world.space, row);
    }
    world.assembly.robots.erase(world.assembly.robots.begin() + (instance - world.assembly.robots.data()));
  }
  world.space.structure.isolate(row);
  world.space.attachments.isolate(row);
  for (const Membership& membership : world.assembly.memberships[row]) {
    callPlugin("remove", partOf(world.assembly.engines, *membership.engine), UserCode::kNoTick,
               [&] { membership.engine->remove(world.space, row); });
  }
  world.space.entities_without_engine.remove(row);
  auto& powered = world.space.powered;
  powered.erase(std::remove(powered.begin(), powered.end(), row), powered.end());
  world.space.entities.remove(row);
}

}  // namespace swarmanoid
