#include "swarmanoid_space/rays/solid_ray.hpp"

#include <algorithm>
#include <limits>

#include "inside_of.hpp"

namespace swarmanoid {
namespace {

/// Rotates a vector; the usual case of a solid that is not rotated in its entity's frame is fast.
Eigen::Vector3d rotated(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& vector) {
  return rotation.vec().isZero(0.0) ? vector : rotation * vector;
}

}  // namespace

double closestHit(const Segment& segment, const EntityModel& model, const Pose& pose) {
  const Eigen::Quaterniond to_body = pose.orientation.conjugate();
  const Eigen::Vector3d start = to_body * (segment.from - pose.position);
  const Eigen::Vector3d step = to_body * (segment.to - segment.from);
  double first = std::numeric_limits<double>::infinity();
  for (const CollisionShape& shape : model.shapes) {
    const Eigen::Quaterniond to_shape = shape.orientation.conjugate();
    const LinePart inside =
        insideOf(shape.kind, shape.half_extent, rotated(to_shape, start - shape.position), rotated(to_shape, step));
    if (!inside.isEmpty() && inside.to >= 0.0 && inside.from <= 1.0) {
      first = std::min(first, std::max(inside.from, 0.0));
    }
  }
  return first;
}

}  // namespace swarmanoid
