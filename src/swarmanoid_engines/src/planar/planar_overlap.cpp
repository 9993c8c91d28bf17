#include "planar/planar_overlap.hpp"

#include <algorithm>
#include <limits>

namespace swarmanoid::planar {
namespace {

/// Distance from the polygon to a point outside it; negative inside.
double distanceTo(const PlanarShape& polygon, const Eigen::Vector2d& point) {
  double deepest = -std::numeric_limits<double>::infinity();
  double nearest_squared = std::numeric_limits<double>::infinity();
  const std::size_t count = polygon.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d& from = polygon.vertices[i];
    const Eigen::Vector2d edge = polygon.vertices[(i + 1) % count] - from;
    const Eigen::Vector2d way = point - from;
    const double length_squared = edge.squaredNorm();
    deepest = std::max(deepest, (edge.y() * way.x() - edge.x() * way.y()) / std::sqrt(length_squared));
    const double t = std::clamp(way.dot(edge) / length_squared, 0.0, 1.0);
    nearest_squared = std::min(nearest_squared, (way - t * edge).squaredNorm());
  }
  return deepest <= 0.0 ? deepest : std::sqrt(nearest_squared);
}

/// Whether an edge of `a` has all of `b` on its outer side (separating axis theorem).
bool hasSeparatingEdge(const PlanarShape& a, const PlanarShape& b) {
  const std::size_t count = a.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d edge = a.vertices[(i + 1) % count] - a.vertices[i];
    const Eigen::Vector2d outward = Eigen::Vector2d(edge.y(), -edge.x()).normalized();
    double gap = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& vertex : b.vertices) {
      gap = std::min(gap, outward.dot(vertex - a.vertices[i]));
    }
    if (gap >= -kContactTolerance) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool overlap(const PlanarShape& a, const PlanarShape& b) {
  const double reach = a.radius + b.radius - kContactTolerance;
  if ((a.centre - b.centre).squaredNorm() >= reach * reach) {
    return false;
  }
  if (a.isCircle() && b.isCircle()) {
    return true;
  }
  if (a.isCircle() || b.isCircle()) {
    const PlanarShape& circle = a.isCircle() ? a : b;
    const PlanarShape& polygon = a.isCircle() ? b : a;
    return distanceTo(polygon, circle.centre) < circle.radius - kContactTolerance;
  }
  return !hasSeparatingEdge(a, b) && !hasSeparatingEdge(b, a);
}

}  // namespace swarmanoid::planar
