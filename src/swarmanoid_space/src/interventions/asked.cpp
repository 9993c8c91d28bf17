// Functions for all kinds of interventions, and interventions that rules request.
#include <stdexcept>
#include <vector>

#include "carry_out.hpp"

namespace swarmanoid {

RobotInstance& requireRobot(World& world, const std::string& name) {
  const Entities& entities = world.space.entities;
  RobotInstance* robot = world.assembly.findRobot(entities, entities.find(name));
  if (robot == nullptr) {
    std::vector<std::string> known;
    for (const RobotInstance& other : world.assembly.robots) {
      known.push_back(entities.name[other.row]);
    }
    throw ConfigError({}, "there is no robot '" + name + "' with a controller" + didYouMean(name, known));
  }
  return *robot;
}

void take(World& world, const Intervention& intervention, const std::string& asked_by, bool after_rules) {
  if (std::visit([&](const auto& kind) { return carryOut(world, kind); }, intervention)) {
    world.pending_interventions.push_back({intervention, asked_by, world.space.tick, after_rules});
  }
}

void takeAsked(World& world) {
  if (world.queue.isEmpty()) {
    return;
  }
  world.queue.takeInto(world.asked);
  for (const AskedIntervention& asked : world.asked) {
    try {
      take(world, asked.what, asked.asked_by, false);
      if (asked.answer != nullptr) {
        asked.answer->setDone();
      }
    } catch (const ConfigError& error) {
      if (asked.answer != nullptr) {
        asked.answer->setRefused(error.what());
      }
      const std::string refusal = asked.asked_by + " asked in tick " + std::to_string(world.space.tick) +
                                  " for what is refused: " + error.what();
      if (!asked.may_be_refused) {
        throw std::runtime_error(refusal);
      }
      world.pending_events.push_back({Event::Kind::kInterventionRefused, "", "", refusal});
    }
  }
}

}  // namespace swarmanoid
