// Robots with an empty battery are switched off: they get no commands until their charge is sufficient. Charge from
// rules and services counts at once.
#include <exception>

#include "../interventions/carry_out.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

void switchOff(World& world, RobotInstance& robot) {
  const CommandSource source = robot.source;
  carryOut(world, SetCommandSource{robot.robot->name(), CommandSource::kNone});
  robot.source_when_charged = source;
}

/// Switches a robot on. If it cannot continue it counts as failed, and the run goes on without it.
void switchOn(World& world, RobotInstance& robot) {
  const CommandSource source = *robot.source_when_charged;
  robot.source_when_charged.reset();
  if (robot.has_failed) {
    return;  // not commanded until a reset
  }
  try {
    carryOut(world, SetCommandSource{robot.robot->name(), source});
  } catch (const std::exception& error) {
    robot.has_failed = true;
    robot.failure = "after its battery was charged " + std::string(error.what());
  }
}

}  // namespace

void Simulation::switchPower() {
  World& world = *world_;
  Space& space = world.space;
  for (const Row row : space.powered) {
    BatteryState& state = space.batteries[row][0];
    judgeEmptiness(*space.entities.model[row]->battery, space.properties[row], state);
    RobotInstance* robot = world.assembly.findRobot(space.entities, row);
    if (robot == nullptr || state.is_empty == robot->source_when_charged.has_value()) {
      continue;
    }
    if (state.is_empty) {
      switchOff(world, *robot);
    } else {
      switchOn(world, *robot);
    }
  }
}

}  // namespace swarmanoid
