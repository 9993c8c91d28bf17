#include "../experiment_file/door.hpp"
#include "../world/entities.hpp"
#include "../world/offers.hpp"
#include "carry_out.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {

bool carryOut(World& world, const DeleteEntity& intervention) {
  const std::string& name = intervention.entity;
  const Row row = world.space.entities.find(name);
  if (row == kNoRow) {
    throw ConfigError({}, "there is no entity '" + name + "'");
  }
  removeEntity(world, row);
  offerRobots(world);
  world.space.index.forget(world.space.entities);
  world.pending_events.push_back({Event::Kind::kDeleted, name, "", ""});
  return true;
}

}  // namespace swarmanoid
