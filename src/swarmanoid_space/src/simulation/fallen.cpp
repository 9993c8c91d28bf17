// Removes entities that have fallen into a hole from the world, in the same tick: they are no longer visible, moved or
// commanded.
#include <algorithm>
#include <cstddef>

#include "../phases/phases.hpp"
#include "../world/entities.hpp"
#include "../world/offers.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

void Simulation::removeFallen() {
  World& world = *world_;
  phases::fall(world.space, fallen_, world.space.events);
  if (fallen_.empty()) {
    return;
  }
  const auto pending = static_cast<std::ptrdiff_t>(world.pending_events.size());
  for (const Row row : fallen_) {
    auto& spots = world.space.laser_spots;
    const EntityNumber number = world.space.entities.number[row];
    spots.erase(std::remove_if(spots.begin(), spots.end(), [&](const LaserSpot& spot) { return spot.owner == number; }),
                spots.end());
    removeEntity(world, row);
  }
  // failures of their controllers belong to this tick, which may be the last one
  const auto added = world.pending_events.begin() + pending;
  world.space.events.insert(world.space.events.end(), added, world.pending_events.end());
  world.pending_events.erase(added, world.pending_events.end());
  offerRobots(world);
}

}  // namespace swarmanoid
