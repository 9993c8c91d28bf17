/// Beams from a robot that end on the ground.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "swarmanoid_space/space.hpp"

namespace swarmanoid::devices {

/// The beam from a point as far as the floor, or as far as it reaches. Where there is a terrain, which replaces the
/// floor, it goes on as deep as the terrain does: a ray along it hits that. @param direction of length 1
/// @param reach [m]
inline Segment beamToGround(const Space& space, const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                            double reach) {
  const auto downTo = [&](double height) -> Eigen::Vector3d {
    const double way = direction.z() < 0.0 ? (height - from.z()) / direction.z() : reach;
    return from + std::clamp(way, 0.0, reach) * direction;
  };
  const Eigen::Vector3d on_floor = downTo(0.0);
  if (space.terrain && space.terrain->contains(on_floor.x(), on_floor.y())) {
    return {from, downTo(space.lowestGround())};
  }
  return {from, on_floor};
}

}  // namespace swarmanoid::devices
