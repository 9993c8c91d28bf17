#include "bounds_of.hpp"

#include <algorithm>

namespace swarmanoid {

Eigen::AlignedBox3d boundsOf(const EntityModel& model, const Pose& pose) {
  Eigen::AlignedBox3d bounds(pose.position);
  for (const CollisionShape& shape : model.shapes) {
    const Eigen::Matrix3d turn = (pose.orientation * shape.orientation).toRotationMatrix();
    const Eigen::Vector3d centre = pose.toWorld(shape.position);
    const bool is_sphere = shape.kind == CollisionShape::Kind::kSphere;
    const Eigen::Vector3d extent = is_sphere ? Eigen::Vector3d(Eigen::Vector3d::Constant(shape.half_extent.x()))
                                             : Eigen::Vector3d(turn.cwiseAbs() * shape.half_extent);
    bounds.extend(centre - extent).extend(centre + extent);
  }
  if (std::any_of(model.shapes.begin(), model.shapes.end(), [](const CollisionShape& s) { return s.joint >= 0; })) {
    // even a turning turret may leave its box
    const Eigen::Vector3d reach = Eigen::Vector3d::Constant(model.moving_reach);
    bounds.extend(pose.position - reach).extend(pose.position + reach);
  }
  return bounds;
}

}  // namespace swarmanoid
