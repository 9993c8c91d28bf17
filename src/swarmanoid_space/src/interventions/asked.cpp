// Interventions that rules ask for.
#include <stdexcept>

#include "carry_out.hpp"

namespace swarmanoid {

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
    } catch (const ConfigError& error) {
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
