/// Intersection of lines of sight and rays with the ground.
///
/// The ground is the level floor, z = 0, except for its holes, and the terrain where there is one, which may be below
/// z = 0 (holes) or above it (slopes). Nothing else hides the floor. On level floor no ray is cast.
#pragma once

#include <algorithm>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

constexpr double kDeepestSpot = 0.01;  // maximum depth of a spot in the ground, along its line of sight, m

/// Whether a point at z = 0 lies on the level floor: neither on terrain nor in a hole. Thread-safe.
/// @param point in W [m]
inline bool isOnLevelFloor(const Space& space, const Eigen::Vector3d& point) {
  return !(space.terrain && space.terrain->contains(point.x(), point.y())) && space.holeAt(point) == nullptr;
}

/// Distance along its line of sight at which a spot meets the ground. Thread-safe.
/// @param spot position in W [m] @param direction of the line of sight, in W, of length 1 @param range [m]
/// @return from -kDeepestSpot to range [m]; infinity without an intersection
inline double wayToGround(const Space& space, const Eigen::Vector3d& spot, const Eigen::Vector3d& direction,
                          double range) {
  double way = direction.z() < 0.0 ? -spot.z() / direction.z() : kInfinity;  // to the level floor
  if (way < -kDeepestSpot || way > range || !isOnLevelFloor(space, spot + way * direction)) {
    way = kInfinity;
  }
  if (!space.terrain) {
    return way;
  }
  const double fraction = space.terrain->closestHit({spot - kDeepestSpot * direction, spot + range * direction});
  return fraction <= 1.0 ? std::min(way, fraction * (kDeepestSpot + range) - kDeepestSpot) : way;
}

}  // namespace swarmanoid::devices
