// The entities of a snapshot: a world that has them keeps its objects; another world is built anew with them.
#include <algorithm>

#include "../world/build.hpp"
#include "../world/entities.hpp"
#include "../world/offers.hpp"
#include "snapshot_data.hpp"

namespace swarmanoid {
namespace {

using Data = Snapshot::Data;

bool areSame(const std::vector<Membership>& memberships, const std::vector<Data::Place>& places,
             const std::vector<Named<Engine>>& engines) {
  return std::equal(memberships.begin(), memberships.end(), places.begin(), places.end(),
                    [&](const Membership& one, const Data::Place& other) {
                      return one.engine == engines[other.engine].get() && one.role == other.role &&
                             one.is_listed == other.is_listed;
                    });
}

bool areSame(const Assembly& assembly, const RobotInstance& instance, const Data::Robot& robot) {
  return instance.group == assembly.groups[robot.group].get() && instance.source == robot.source &&
         instance.command_timeout == robot.command_timeout && (instance.controller != nullptr) == robot.has_controller;
}

bool hasEntities(World& world, const Data& data) {
  const Entities& entities = world.space.entities;
  if (entities.rowCount() != data.row_count || entities.size() != data.entities.size()) {
    return false;
  }
  auto robot = world.assembly.robots.cbegin();
  for (std::size_t i = 0; i < data.entities.size(); ++i) {
    const Data::Entity& entity = data.entities[i];
    const Row row = entities.order[i];
    const bool is_robot = robot != world.assembly.robots.cend() && robot->row == row;
    if (row != entity.row || entities.number[row] != entity.number || entities.name[row] != entity.name ||
        entities.model[row]->type != entity.model->type || is_robot != entity.robot.has_value() ||
        !areSame(world.assembly.memberships[row], entity.places, world.assembly.engines) ||
        (is_robot && !areSame(world.assembly, *robot, *entity.robot))) {
      return false;
    }
    robot += is_robot ? 1 : 0;
  }
  return true;
}

void add(World& world, const Data::Entity& entity) {
  EntityDescription description;
  description.id = entity.name;
  description.type = entity.model->type;
  if (entity.robot) {
    description.type = entity.robot->type;
    description.controller = world.assembly.groups[entity.robot->group]->description->id;
    description.source = entity.robot->source;
    description.command_timeout = entity.robot->command_timeout;
  }
  std::vector<Membership> memberships;
  for (const Data::Place& place : entity.places) {
    memberships.push_back({world.assembly.engines[place.engine].get(), place.role, place.is_listed});
  }
  addEntityAt(world, entity.row, entity.number, description, entity.model, entity.pose, memberships);
  if (entity.robot && !entity.robot->has_controller) {
    world.assembly.robots.back().controller.reset();
  }
}

void restoreTriggers(World& world, const std::vector<Data::Trigger>& triggers) {
  world.assembly.triggers.clear();
  for (const Data::Trigger& trigger : triggers) {
    const HandoverDescription& rule = world.experiment.handovers.at(trigger.rule);
    world.assembly.triggers.push_back({&rule, world.assembly.findEngine(rule.engine), trigger.row, trigger.number,
                                       trigger.was_true, trigger.is_due, trigger.is_refused});
  }
}

}  // namespace

void restoreStructure(World& world, const Data& data) {
  if (!hasEntities(world, data)) {
    unbuild(world);
    buildControllerGroups(world);
    world.space.entities.columns.resize(data.row_count);
    for (const Data::Entity& entity : data.entities) {
      add(world, entity);
    }
    offerRobots(world);
  }
  restoreTriggers(world, data.triggers);
}

}  // namespace swarmanoid
