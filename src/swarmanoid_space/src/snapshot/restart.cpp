#include "restart.hpp"

#include <stdexcept>

#include "../world/build.hpp"
#include "../world/distribute.hpp"
#include "../world/entities.hpp"

namespace swarmanoid {
namespace {

/// Places the entities of distributions, in the order of the file.
void placeAgain(World& world) {
  for (const EntityDescription& entity : world.experiment.arena.entities) {
    if (entity.distribution && entity.distribution->quantity > 0) {
      distribute(world, entity, world.assembly.memberships[world.space.entities.require(entity.id + "_1")], true);
    }
  }
}

void restartRobots(World& world) {
  for (const auto& group : world.assembly.groups) {
    for (const auto& sensor : group->sensors) {
      sensor->restart(world.space);
    }
    for (const auto& actuator : group->actuators) {
      actuator->restart(world.space);
    }
    if (group->together != nullptr) {
      initTogether(*group);
    }
  }
  for (RobotInstance& instance : world.assembly.robots) {
    destroyController(world, instance);
    instance.robot->restart(world.space.seed);
    if (instance.source == CommandSource::kController) {
      instance.controller = startControllerOf(instance, world.space);
    }
  }
}

}  // namespace

std::unique_ptr<const Snapshot::Data> startOf(World& world) {
  constexpr std::size_t kMostEntities = 200;
  const SuppliedParts& supplied = world.supplied;
  const bool is_of_files = supplied.rules.empty() && supplied.group_controllers.size() <= 1;  // one: the agents
  if (world.space.entities.size() > kMostEntities || supplied.scripts != nullptr || !is_of_files) {
    return nullptr;
  }
  try {
    return takeSnapshot(world);
  } catch (const std::runtime_error&) {
    return nullptr;  // a part does not define its state
  }
}

void restart(World& world, const Snapshot::Data& start) {
  const std::uint64_t seed = world.space.seed;
  restoreSnapshot(world, start);
  world.space.seed = seed;
  world.experiment.framework.seed = seed;
  placeAgain(world);
  restartRobots(world);
  for (HandoverTrigger& trigger : world.assembly.triggers) {
    trigger.was_true = holds(*trigger.rule, world.space, trigger.row);
  }
  world.space.index.forget(world.space.entities);  // rules use the index when the run begins
}

}  // namespace swarmanoid
