#include "planar/planar_overlap.hpp"

#include <algorithm>
#include <limits>

namespace swarmanoid::planar {
namespace {

/// Whether a point is in a polygon or closer to it than a distance. One edge rejects most pairs, without a root or a
/// division.
bool isNearer(const PlanarShape& polygon, const Eigen::Vector2d& point, double distance) {
  const double distance_squared = distance * distance;
  bool is_inside = true;
  const Eigen::Vector2d* corner = &polygon.vertices.back();
  for (const Eigen::Vector2d& next : polygon.vertices) {
    const Eigen::Vector2d edge = next - *corner;
    const Eigen::Vector2d way = point - *corner;
    corner = &next;
    const double outside = edge.y() * way.x() - edge.x() * way.y();  // distance from the edge, times its length
    if (outside <= 0.0) {
      continue;
    }
    is_inside = false;
    const double length_squared = edge.squaredNorm();
    if (outside * outside >= distance_squared * length_squared) {
      return false;
    }
    const double along = way.dot(edge);
    const bool is_beside = along >= 0.0 && along <= length_squared;
    const Eigen::Vector2d from_end = along < 0.0 ? way : way - edge;
    if (is_beside || from_end.squaredNorm() < distance_squared) {
      return true;
    }
  }
  return is_inside;
}

/// Whether all of `b` is on the outer side of one edge of `a` (separating axis theorem).
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

/// The edge of `a` with the least depth of `b`; the normal points out of `a`.
Penetration leastDepth(const PlanarShape& a, const PlanarShape& b) {
  Penetration least{std::numeric_limits<double>::infinity(), {}};
  const std::size_t count = a.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d edge = a.vertices[(i + 1) % count] - a.vertices[i];
    const Eigen::Vector2d outward = Eigen::Vector2d(edge.y(), -edge.x()).normalized();
    double depth = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& vertex : b.vertices) {
      depth = std::max(depth, outward.dot(a.vertices[i] - vertex));
    }
    if (depth < least.depth) {
      least = {depth, outward};
    }
  }
  return least;
}

/// The shortest way of a circle out of a polygon: across the nearest edge, or away from the nearest vertex.
Penetration leaveByNearest(const PlanarShape& circle, const PlanarShape& polygon) {
  double deepest = -std::numeric_limits<double>::infinity();
  double nearest_squared = std::numeric_limits<double>::infinity();
  Eigen::Vector2d outward = Eigen::Vector2d::UnitX();
  Eigen::Vector2d from_nearest = Eigen::Vector2d::UnitX();
  const std::size_t count = polygon.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2d& from = polygon.vertices[i];
    const Eigen::Vector2d edge = polygon.vertices[(i + 1) % count] - from;
    const Eigen::Vector2d way = circle.centre - from;
    const double length_squared = edge.squaredNorm();
    const Eigen::Vector2d normal = Eigen::Vector2d(edge.y(), -edge.x()) / std::sqrt(length_squared);
    if (const double outside = normal.dot(way); outside > deepest) {
      deepest = outside;
      outward = normal;
    }
    const Eigen::Vector2d off = way - std::clamp(way.dot(edge) / length_squared, 0.0, 1.0) * edge;
    if (off.squaredNorm() < nearest_squared) {
      nearest_squared = off.squaredNorm();
      from_nearest = off;
    }
  }
  if (deepest <= 0.0) {
    return {circle.radius - deepest, outward};
  }
  const double distance = std::sqrt(nearest_squared);
  return {circle.radius - distance, from_nearest / distance};
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
    return isNearer(polygon, circle.centre, circle.radius - kContactTolerance);
  }
  return !hasSeparatingEdge(a, b) && !hasSeparatingEdge(b, a);
}

Penetration penetration(const PlanarShape& a, const PlanarShape& b) {
  if (a.isCircle() && b.isCircle()) {
    const Eigen::Vector2d way = a.centre - b.centre;
    const double distance = way.norm();
    const Eigen::Vector2d normal = distance > 0.0 ? Eigen::Vector2d(way / distance) : Eigen::Vector2d::UnitX();
    return {a.radius + b.radius - distance, normal};
  }
  if (a.isCircle()) {
    return leaveByNearest(a, b);
  }
  if (b.isCircle()) {
    const Penetration other_way = leaveByNearest(b, a);
    return {other_way.depth, -other_way.normal};
  }
  const Penetration by_a = leastDepth(a, b);
  const Penetration by_b = leastDepth(b, a);
  return by_b.depth <= by_a.depth ? by_b : Penetration{by_a.depth, -by_a.normal};
}

}  // namespace swarmanoid::planar
