#include "../world/entities.hpp"
#include "../world/offers.hpp"
#include "carry_out.hpp"

namespace swarmanoid {

bool carryOut(World& world, const DeleteEntity& intervention) {
  const std::string& name = intervention.entity;
  const Row row = world.space.entities.require(name);
  removeEntity(world, row);
  offerRobots(world);
  world.space.index.forget(world.space.entities);
  world.pending_events.push_back({Event::Kind::kDeleted, name, "", ""});
  return true;
}

}  // namespace swarmanoid
