// The state of all objects of a world, in one order for saving and loading.
#include <string>

#include "snapshot_data.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {
namespace {

/// Calls `archive` of a plugin. @throws std::runtime_error naming it if its state is not defined
template <class Action>
void archivePart(const std::string& part, Action archive) {
  try {
    callPlugin("archive", part, UserCode::kNoTick, archive);
  } catch (const StateNotDefined& error) {
    throw std::runtime_error(part + " " + error.what() + ", so the run has no snapshots");
  }
}

void archiveRobots(World& world, StateArchive& state) {
  for (RobotInstance& instance : world.assembly.robots) {
    state(*instance.robot);
    state(instance.has_failed, instance.is_commanded, instance.stops_since, instance.source_when_charged,
          instance.last_command, instance.failure);
  }
  for (const auto& group : world.assembly.groups) {
    for (const auto& sensor : group->sensors) {
      archivePart(sensor.part, [&] { sensor->archive(world.space, state); });
    }
    for (const auto& actuator : group->actuators) {
      archivePart(actuator.part, [&] { actuator->archive(world.space, state); });
    }
    if (group->together != nullptr) {
      archivePart(group->part, [&] { group->together->archive(world.space, world.space.commands, state); });
    }
  }
  for (RobotInstance& instance : world.assembly.robots) {
    if (instance.controller != nullptr) {
      archivePart(instance.group->part, [&] { instance.controller->archive(state); });
    }
  }
}

}  // namespace

void archiveState(World& world, StateArchive& state) {
  world.space.entities.archive(state);
  state(world.space.attachments, world.space.floor.paint);
  archiveRobots(world, state);
  for (const auto& engine : world.assembly.engines) {
    archivePart(engine.part, [&] { engine->archive(world.space, state); });
  }
  for (const RuleInstance& rule : world.assembly.rules) {
    archivePart(rule.part, [&] { rule->archiveAll(state); });
  }
}

}  // namespace swarmanoid
