#include "dynamics3d/bounds.hpp"

#include <cmath>

namespace swarmanoid::dynamics3d {

Eigen::AlignedBox3d boundsOf(const EntityModel& model, const Pose& pose) {
  Eigen::AlignedBox3d bounds;
  for (const CollisionShape& shape : model.shapes) {
    const Eigen::Matrix3d axes = (pose.orientation * shape.orientation).toRotationMatrix();
    const Eigen::Vector3d& half = shape.half_extent;
    Eigen::Vector3d reach = Eigen::Vector3d::Constant(half.x());
    if (shape.kind == CollisionShape::Kind::kBox) {
      reach = axes.cwiseAbs() * half;
    } else if (shape.kind == CollisionShape::Kind::kCylinder) {
      for (int i = 0; i < 3; ++i) {
        reach[i] = half.x() * std::hypot(axes(i, 0), axes(i, 1)) + half.z() * std::abs(axes(i, 2));
      }
    }
    const Eigen::Vector3d centre = pose.position + pose.orientation * shape.position;
    bounds.extend(centre - reach).extend(centre + reach);
  }
  return bounds;
}

}  // namespace swarmanoid::dynamics3d
