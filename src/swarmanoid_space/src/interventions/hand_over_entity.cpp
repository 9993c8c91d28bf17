// Handover between engines (thesis chapter 5), asked for from outside.
#include "carry_out.hpp"

namespace swarmanoid {
namespace {

std::vector<std::string> engineIds(const Space& space) {
  std::vector<std::string> ids;
  for (const Engine* engine : space.engines) {
    ids.push_back(engine->id());
  }
  return ids;
}

}  // namespace

bool carryOut(World& world, const HandOverEntity& intervention) {
  const std::string& name = intervention.entity;
  const std::string& engine_id = intervention.engine;
  const Row row = requireEntity(world, name);
  Engine* engine = world.assembly.findEngine(engine_id);
  if (engine == nullptr) {
    const std::vector<std::string> known = engineIds(world.space);
    throw ConfigError(
        {}, "engine '" + engine_id + "' does not exist; there are: " + joinNames(known) + didYouMean(engine_id, known));
  }
  if (world.space.mover[row] == engine && world.space.entities.model[row]->is_movable) {
    return false;
  }
  const std::vector<Row> members =
      connectedTo(world.space.entities, world.space.structure, world.space.attachments, row);
  refreshMirrors(world.space, world.assembly.memberships, *engine);
  const std::string problem =
      handoverProblem(world.space, world.assembly.robots, world.assembly.memberships, members, row, *engine);
  if (!problem.empty()) {
    throw ConfigError({}, world.space.entities.model[row]->type + " '" + name + "' cannot be handed over to engine '" +
                              engine_id + "': " + problem);
  }
  world.pending_events.push_back({Event::Kind::kIntervention, name, "", "handover to " + engine_id});
  commitHandover(world.space, world.assembly.robots, world.assembly.memberships, members, *engine,
                 world.pending_events);
  return true;
}

}  // namespace swarmanoid
