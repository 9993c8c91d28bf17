// Handover between engines (thesis chapter 5), requested from outside.
#include "../world/engines.hpp"
#include "carry_out.hpp"

namespace swarmanoid {

bool carryOut(World& world, const HandOverEntity& intervention) {
  const std::string& name = intervention.entity;
  const std::string& engine_id = intervention.engine;
  const Row row = world.space.entities.require(name);
  Engine* engine = world.assembly.engines[engineIndex(world, engine_id)].get();
  if (world.space.mover[row] == engine && world.space.entities.model[row]->is_movable) {
    return false;
  }
  Handover handover(world.space, HandOverAccess(world.space), world.assembly.engines, world.assembly.robots,
                    world.assembly.memberships, row, *engine);
  const std::string problem = handover.problem();
  if (!problem.empty()) {
    throw ConfigError({}, world.space.entities.model[row]->type + " '" + name + "' cannot be handed over to engine '" +
                              engine_id + "': " + problem);
  }
  world.pending_events.push_back({Event::Kind::kIntervention, name, "", "handover to " + engine_id});
  handover.commit(world.pending_events);
  return true;
}

}  // namespace swarmanoid
