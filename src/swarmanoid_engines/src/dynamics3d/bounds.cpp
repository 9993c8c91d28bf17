#include "dynamics3d/bounds.hpp"

#include "dynamics3d/collision/placed_solid.hpp"

namespace swarmanoid::dynamics3d {

Eigen::AlignedBox3d boundsOf(const EntityModel& model, const Pose& pose) {
  Eigen::AlignedBox3d bounds;
  for (const CollisionShape& shape : model.shapes) {
    bounds.extend(PlacedSolid(shape, pose).bounds());
  }
  return bounds;
}

}  // namespace swarmanoid::dynamics3d
