/// The part of a line that is inside a solid, for rays and for the occlusion of LEDs.
#pragma once

#include <Eigen/Core>

#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/rays/line_part.hpp"

namespace swarmanoid {

/// Returns the part of the infinite line, not only of the segment. @param half_extent as in CollisionShape
/// @param start, step in the shape's frame [m]
inline LinePart insideOf(CollisionShape::Kind kind, const Eigen::Vector3d& half_extent, const Eigen::Vector3d& start,
                         const Eigen::Vector3d& step) {
  LinePart inside = LinePart::whole();
  switch (kind) {
    case CollisionShape::Kind::kBox:
      for (int axis = 0; axis < 3; ++axis) {
        inside.clipToSlab(start[axis], step[axis], -half_extent[axis], half_extent[axis]);
      }
      break;
    case CollisionShape::Kind::kCylinder:
      inside.clipToSlab(start.z(), step.z(), -half_extent.z(), half_extent.z());
      inside.clipToRound(Eigen::Vector2d(start.head<2>()), Eigen::Vector2d(step.head<2>()), half_extent.x());
      break;
    case CollisionShape::Kind::kSphere:
      inside.clipToRound(start, step, half_extent.x());
      break;
  }
  return inside;
}

}  // namespace swarmanoid
