#include "../world/entities.hpp"
#include "../world/offers.hpp"
#include "carry_out.hpp"
#include "swarmanoid_space/experiment/entity_validation.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

void refuseIfNobodyCommands(const World& world, const EntityDescription& entity) {
  try {
    refuseUnlessServed(world, entity.source);
  } catch (const std::runtime_error& error) {
    throw commandRefusal(entity.location, entity.id, entity.source, error.what());
  }
}

}  // namespace

bool carryOut(World& world, const SpawnEntity& intervention) {
  const EntityDescription& entity = intervention.entity;
  if (entity.distribution) {
    throw ConfigError(entity.location, "found a distribution of '" + entity.id + "', allowed: one entity");
  }
  validation::check(entity, world.experiment);
  refuseIfNobodyCommands(world, entity);
  std::vector<Claim> claims;
  for (const std::string& engine : intervention.engines) {
    claims.push_back({engine, std::nullopt, entity.location});
  }
  const std::vector<Membership> memberships = membershipsOf(entity.id, claims, world.assembly.engines);
  if (world.space.entities.size() >= limits::kMostEntities) {
    throw ConfigError(entity.location, "found " + std::to_string(world.space.entities.size()) +
                                           " entities in the arena already, allowed: no more");
  }
  addEntity(world, entity, memberships);
  offerRobots(world);
  world.space.index.forget(world.space.entities);
  world.pending_events.push_back({Event::Kind::kSpawned, entity.id, "", entity.type});
  return true;
}

}  // namespace swarmanoid
