#include <algorithm>
#include <stdexcept>

#include "snapshot_data.hpp"

namespace swarmanoid {
namespace {

using Data = Snapshot::Data;

template <class Plugin>
std::size_t placeOf(const std::vector<Named<Plugin>>& plugins, const Plugin* plugin) {
  const auto found =
      std::find_if(plugins.begin(), plugins.end(), [&](const auto& known) { return known.get() == plugin; });
  return static_cast<std::size_t>(found - plugins.begin());
}

Data::Robot robotOf(const World& world, const RobotInstance& instance) {
  if (instance.source == CommandSource::kRemote) {
    throw std::runtime_error("'" + instance.robot->name() +
                             "' is commanded from another process, so the run has no snapshots");
  }
  const auto& groups = world.assembly.groups;
  const auto group =
      std::find_if(groups.begin(), groups.end(), [&](const auto& known) { return known.get() == instance.group; });
  return {instance.robot->type(), static_cast<std::size_t>(group - groups.begin()), instance.source,
          instance.command_timeout, instance.controller != nullptr};
}

Data::Entity entityOf(World& world, Row row) {
  const Space& space = world.space;
  Data::Entity entity{row,
                      space.entities.number[row],
                      space.entities.name[row],
                      space.entities.model[row],
                      space.entities.pose[row],
                      {},
                      {}};
  for (const Membership& membership : world.assembly.memberships[row]) {
    entity.places.push_back(
        {placeOf(world.assembly.engines, membership.engine), membership.role, membership.is_listed});
  }
  return entity;
}

void takeEntities(World& world, Data& data) {
  data.row_count = world.space.entities.rowCount();
  auto robot = world.assembly.robots.cbegin();  // by entity number, as the entities
  for (const Row row : world.space.entities.order) {
    data.entities.push_back(entityOf(world, row));
    if (robot != world.assembly.robots.cend() && robot->row == row) {
      data.entities.back().robot = robotOf(world, *robot);
      ++robot;
    }
  }
  for (const HandoverTrigger& trigger : world.assembly.triggers) {
    const auto rule = static_cast<std::size_t>(trigger.rule - world.experiment.handovers.data());
    data.triggers.push_back({rule, trigger.row, trigger.number, trigger.was_true, trigger.is_due, trigger.is_refused});
  }
}

}  // namespace

std::unique_ptr<Data> takeSnapshot(World& world) {
  auto data = std::make_unique<Data>();
  data->parts = partsOf(world);
  data->controllers = controllersOf(world);
  takeEntities(world, *data);
  StateArchive archive(data->bytes);
  archiveState(world, archive);
  const Space& space = world.space;
  data->tick = space.tick;
  data->time = space.time;
  data->seed = space.seed;
  data->engine_parameters = world.engine_parameters;
  data->laser_spots = space.laser_spots;
  data->events = space.events;
  data->pending_events = world.pending_events;
  data->interventions = space.interventions;
  data->pending_interventions = world.pending_interventions;
  data->overflows = space.overflows;
  data->failures = world.failures;
  data->queue = world.queue;
  return data;
}

std::vector<std::type_index> controllersOf(const World& world) {
  std::vector<std::type_index> controllers;
  for (const auto& group : world.assembly.groups) {
    const GroupController* const together = group->together.get();
    controllers.emplace_back(together == nullptr ? typeid(void) : typeid(*together));
  }
  return controllers;
}

std::vector<std::string> partsOf(const World& world) {
  std::vector<std::string> parts;
  for (const auto& engine : world.assembly.engines) {
    parts.push_back(engine.part);
  }
  for (const auto& group : world.assembly.groups) {
    parts.push_back(group->part);
    for (const auto& sensor : group->sensors) {
      parts.push_back(sensor.part);
    }
    for (const auto& actuator : group->actuators) {
      parts.push_back(actuator.part);
    }
  }
  for (const RuleInstance& rule : world.assembly.rules) {
    parts.push_back(rule.part);
  }
  return parts;
}

}  // namespace swarmanoid
