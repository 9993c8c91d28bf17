#include "swarmanoid_space/state/floor.hpp"

namespace swarmanoid {

Eigen::Vector3d FloorPatch::nearestPoint(const Eigen::Vector3d& point) const {
  Eigen::Vector2d offset = (point - position).head<2>();
  if (radius > 0.0) {
    const double distance = offset.norm();
    offset *= distance > radius ? radius / distance : 1.0;
  } else {
    offset = offset.cwiseMax(-0.5 * size).cwiseMin(0.5 * size);
  }
  return position + Eigen::Vector3d(offset.x(), offset.y(), 0.0);
}

}  // namespace swarmanoid
