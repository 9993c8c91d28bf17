// Phase 6: the positional index gets the new poses; entities that have left the arena get an event.
#include <atomic>

#include "phases.hpp"

namespace swarmanoid::phases {
namespace {

/// Range of an entity's origin inside the arena.
struct Inside {
  Eigen::Array3d least;
  Eigen::Array3d most;

  bool holds(const Eigen::Vector3d& p) const { return (p.array() >= least).all() && (p.array() <= most).all(); }
};

/// @return whether any entity has entered or left since `outside` was written
bool hasAnyoneCrossed(const ByRow<Pose>& poses, const ByRow<char>& outside, const Inside& inside,
                      const Workers& workers) {
  std::atomic<bool> has_crossed{false};
  const auto count = static_cast<std::size_t>(poses.end() - poses.begin());
  workers.forRanges(count, kGrainOfPoses, [&](std::size_t first, std::size_t last) {
    bool found = false;
    for (std::size_t i = first; i < last; ++i) {
      const bool is_outside = !inside.holds(poses[rowAt(i)].position);
      found = found || is_outside != (outside[rowAt(i)] != 0);
    }
    if (found) {
      has_crossed = true;
    }
  });
  return has_crossed;
}

}  // namespace

void index(const Space& space, const IndexAccess& access, const Workers& workers) {
  constexpr double kTolerance = 1e-3;  // m
  constexpr double kSunk = 0.1;  // m: below the ground; hard landings sink in by centimetres without leaving the arena
  access.index.update(space.entities);
  const Inside inside{{space.corner.x() - kTolerance, space.corner.y() - kTolerance, space.lowestGround() - kSunk},
                      space.farCorner().array() + kTolerance};
  if (!hasAnyoneCrossed(space.entities.pose, access.outside, inside, workers)) {
    return;
  }
  for (const Row row : space.entities.order) {
    const bool is_outside = !inside.holds(space.entities.pose[row].position);
    if (is_outside && access.outside[row] == 0 && space.entities.model[row]->is_movable) {
      access.events.push_back({Event::Kind::kLeftArena, space.entities.name[row], "", ""});
    }
    access.outside[row] = is_outside ? 1 : 0;
  }
}

}  // namespace swarmanoid::phases
