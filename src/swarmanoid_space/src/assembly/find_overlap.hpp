/// Searches for overlaps, ignoring those that are allowed: fixed entities with each other, entities that another engine
/// moves.
///
/// Phase    between ticks. Threads: see Engine::overlap. Errors: exceptions of the engine.
#pragma once

#include <vector>

#include "swarmanoid_space/engine.hpp"

namespace swarmanoid {

/// Returns the first entity, in the engine's order, that a new one at a pose would overlap and that `counts` accepts;
/// kNoRow if there is none. @param ignored entities left out of the search @param counts bool(Row)
template <class Counts>
Row findOverlap(const Engine& engine, const EntityModel& model, const Pose& pose, std::vector<Row> ignored,
                Counts counts) {
  while (true) {
    const Row other = engine.overlap(model, pose, ignored);
    if (other == kNoRow || counts(other)) {
      return other;
    }
    ignored.push_back(other);
  }
}

}  // namespace swarmanoid
