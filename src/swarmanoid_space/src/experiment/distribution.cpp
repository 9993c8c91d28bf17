// The areas in which <distribute> places entities.
#include <cmath>

#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {

Eigen::AlignedBox3d Distribution::bounds() const {
  switch (area) {
    case Area::kBox:
      return {minimum, maximum};
    case Area::kDisc:
    case Area::kRing: {
      const Eigen::Vector3d reach(radius, radius, 0.0);
      return {Eigen::Vector3d(center - reach), Eigen::Vector3d(center + reach)};
    }
    case Area::kLine:
      break;
  }
  return {Eigen::Vector3d(from.cwiseMin(to)), Eigen::Vector3d(from.cwiseMax(to))};
}

Eigen::Vector3d Distribution::pointAt(const Eigen::Vector3d& shares) const {
  switch (area) {
    case Area::kBox: {
      const Eigen::Vector3d extent = maximum - minimum;
      return minimum + extent.cwiseProduct(shares);
    }
    case Area::kDisc:
    case Area::kRing: {
      // uniform over the area, which grows with the square of the distance from the middle
      const double inner = inner_radius * inner_radius;
      const double distance = std::sqrt(inner + shares.x() * (radius * radius - inner));
      const double angle = 2.0 * M_PI * shares.y();
      return center + distance * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    }
    case Area::kLine:
      break;
  }
  return from + shares.x() * (to - from);
}

}  // namespace swarmanoid
