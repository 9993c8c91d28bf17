/// Overlaps that count, where some do not: of fixed entities with each other, or of what another engine moves.
///
/// Phase    between ticks. Threads: as Engine::overlap. Errors: what engines throw.
#pragma once

#include <vector>

#include "swarmanoid_space/engine.hpp"

namespace swarmanoid {

/// The first entity that counts of those that a new one at a pose would overlap in an engine, in the engine's order;
/// kNoRow if there is none. @param ignored is not asked about @param counts bool(Row)
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
