#include <algorithm>

#include "../world/engines.hpp"
#include "snapshot_data.hpp"
#include "swarmanoid_interface/expects.hpp"

namespace swarmanoid {
namespace {

using Data = Snapshot::Data;

/// @throws ConfigError with the first part that differs
void refuseOfOtherExperiment(const World& world, const Data& data) {
  const std::vector<std::string> parts = partsOf(world);
  const auto [mine, other] = std::mismatch(parts.begin(), parts.end(), data.parts.begin(), data.parts.end());
  if (mine != parts.end() || other != data.parts.end()) {
    throw ConfigError({}, "found a snapshot with " + (other == data.parts.end() ? "nothing more" : *other) +
                              ", allowed: one of the same experiment, with " +
                              (mine == parts.end() ? "nothing more" : *mine) + " there");
  }
  const std::vector<std::type_index> controllers = controllersOf(world);
  for (std::size_t i = 0; i < controllers.size(); ++i) {
    if (controllers[i] != data.controllers[i]) {
      throw ConfigError({}, "found a snapshot in which " + world.assembly.groups[i]->part +
                                " is another one, such as one in Python, allowed: the same");
    }
  }
}

}  // namespace

void restoreSnapshot(World& world, const Data& data) {
  refuseOfOtherExperiment(world, data);
  Space& space = world.space;
  space.tick = data.tick;
  space.time = data.time;
  space.seed = data.seed;
  world.experiment.framework.seed = data.seed;
  restoreStructure(world, data);
  for (std::size_t i = 0; i < data.engine_parameters.size(); ++i) {
    if (world.engine_parameters[i] != data.engine_parameters[i]) {
      reconfigureEngine(world, i, data.engine_parameters[i]);
    }
  }
  StateArchive archive{Span<const std::byte>(data.bytes)};
  archiveState(world, archive);
  SWARMANOID_EXPECTS(archive.isAtEnd());
  for (const Row row : space.entities.order) {
    if (space.entities_without_engine.has(row)) {
      space.entities_without_engine.place(space.entities, row);
    }
  }
  space.index.forget(space.entities);
  space.laser_spots = data.laser_spots;
  space.events = data.events;
  world.pending_events = data.pending_events;
  space.interventions = data.interventions;
  world.pending_interventions = data.pending_interventions;
  space.overflows = data.overflows;
  world.failures = data.failures;
  world.queue = data.queue;
}

}  // namespace swarmanoid
