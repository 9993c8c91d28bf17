#include "swarmanoid_space/state/floor.hpp"

#include <algorithm>

namespace swarmanoid {

Eigen::Vector3d FloorArea::nearestPoint(const Eigen::Vector3d& point) const {
  Eigen::Vector2d offset = (point - position).head<2>();
  if (radius > 0.0) {
    const double distance = offset.norm();
    offset *= distance > radius ? radius / distance : 1.0;
  } else {
    offset = offset.cwiseMax(-0.5 * size).cwiseMin(0.5 * size);
  }
  return position + Eigen::Vector3d(offset.x(), offset.y(), 0.0);
}

const Color* FloorImage::colorAt(const Eigen::Vector3d& point) const {
  const Eigen::Vector2d end = corner + size;
  if (!(point.x() >= corner.x() && point.y() >= corner.y() && point.x() <= end.x() && point.y() <= end.y())) {
    return nullptr;
  }
  const Eigen::Vector2d part = (point.head<2>() - corner).cwiseQuotient(size);
  const int column = std::min(static_cast<int>(part.x() * columns), columns - 1);
  const int row_from_below = std::min(static_cast<int>(part.y() * rows), rows - 1);
  const auto pixel = static_cast<std::size_t>(rows - 1 - row_from_below) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column);
  return is_opaque[pixel] != 0 ? &colors[pixel] : nullptr;
}

}  // namespace swarmanoid
