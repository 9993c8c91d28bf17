// Two convex solids overlap if the origin lies in the set of differences between their points (Gilbert, Johnson,
// Keerthi 1988). The set's point nearest to the origin is found by way of simplices; a direction in which the whole set
// lies beyond the origin proves that they are apart.
#include "dynamics3d/convex_overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

/// A shape in W, smaller by half of the tolerance.
struct PlacedShape {
  PlacedShape(const CollisionShape& shape, const Pose& pose)
      : kind(shape.kind),
        half((shape.half_extent.array() - kContactTolerance / 2.0).max(0.0)),
        centre(pose.toWorld(shape.position)),
        axes((pose.orientation * shape.orientation).toRotationMatrix()) {}

  /// The point that lies farthest in a direction.
  Vector3d farthest(const Vector3d& direction) const {
    const Vector3d d = axes.transpose() * direction;
    const auto along = [](double extent, double component) { return component < 0.0 ? -extent : extent; };
    if (kind == CollisionShape::Kind::kBox) {
      return centre + axes * Vector3d(along(half.x(), d.x()), along(half.y(), d.y()), along(half.z(), d.z()));
    }
    const double length = kind == CollisionShape::Kind::kSphere ? d.norm() : std::hypot(d.x(), d.y());
    Vector3d point = length > 0.0 ? Vector3d(half.x() / length * d) : Vector3d::Zero();
    if (kind == CollisionShape::Kind::kCylinder) {
      point.z() = along(half.z(), d.z());
    }
    return centre + axes * point;
  }

  CollisionShape::Kind kind;
  Vector3d half;
  Vector3d centre;
  Eigen::Matrix3d axes;
};

struct Simplex {
  std::array<Vector3d, 4> points{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  int count = 0;
};

/// The point of a simplex nearest to the origin; reduces the simplex to the points that are needed for it.
Vector3d nearestOfSegment(Simplex& s) {
  const Vector3d edge = s.points[1] - s.points[0];
  const double length_squared = edge.squaredNorm();
  const double t = length_squared > 0.0 ? -s.points[0].dot(edge) / length_squared : 0.0;
  if (t <= 0.0 || t >= 1.0) {
    s.points[0] = s.points[t <= 0.0 ? 0 : 1];
    s.count = 1;
    return s.points[0];
  }
  return s.points[0] + t * edge;
}

Vector3d nearestOfTriangle(Simplex& s) {
  const Vector3d a = s.points[0];
  const Vector3d normal = (s.points[1] - a).cross(s.points[2] - a);
  bool is_inside = normal.squaredNorm() > 0.0;
  for (int i = 0; i < 3 && is_inside; ++i) {
    const Vector3d& from = s.points[static_cast<std::size_t>(i)];
    const Vector3d& to = s.points[static_cast<std::size_t>((i + 1) % 3)];
    is_inside = normal.dot((to - from).cross(-from)) >= 0.0;
  }
  if (is_inside) {
    return normal.dot(a) / normal.squaredNorm() * normal;
  }
  Simplex best;
  Vector3d nearest = Vector3d::Zero();
  for (int i = 0; i < 3; ++i) {
    Simplex edge;
    edge.count = 2;
    edge.points[0] = s.points[static_cast<std::size_t>(i)];
    edge.points[1] = s.points[static_cast<std::size_t>((i + 1) % 3)];
    const Vector3d candidate = nearestOfSegment(edge);
    if (best.count == 0 || candidate.squaredNorm() < nearest.squaredNorm()) {
      best = edge;
      nearest = candidate;
    }
  }
  s = best;
  return nearest;
}

/// Zero if the origin is inside.
Vector3d nearestOfTetrahedron(Simplex& s) {
  Simplex best;
  Vector3d nearest = Vector3d::Zero();
  for (int left_out = 0; left_out < 4; ++left_out) {
    Simplex face;
    for (int i = 0; i < 4; ++i) {
      if (i != left_out) {
        face.points[static_cast<std::size_t>(face.count++)] = s.points[static_cast<std::size_t>(i)];
      }
    }
    const Vector3d normal = (face.points[1] - face.points[0]).cross(face.points[2] - face.points[0]);
    const double apex = normal.dot(s.points[static_cast<std::size_t>(left_out)] - face.points[0]);
    const double origin = -normal.dot(face.points[0]);
    if (apex * origin > 0.0) {
      continue;  // on the same side of this face: not the way out
    }
    const Vector3d candidate = nearestOfTriangle(face);
    if (best.count == 0 || candidate.squaredNorm() < nearest.squaredNorm()) {
      best = face;
      nearest = candidate;
    }
  }
  if (best.count > 0) {
    s = best;
  }
  return nearest;
}

Vector3d nearestOf(Simplex& s) {
  switch (s.count) {
    case 1:
      return s.points[0];
    case 2:
      return nearestOfSegment(s);
    case 3:
      return nearestOfTriangle(s);
    default:
      return nearestOfTetrahedron(s);
  }
}

bool overlap(const PlacedShape& a, const PlacedShape& b) {
  constexpr int kMostRounds = 200;
  constexpr double kInside = 1e-20;  // m2
  const auto farthest = [&](const Vector3d& direction) {
    return Vector3d(a.farthest(direction) - b.farthest(-direction));
  };
  Simplex simplex;
  simplex.points[0] = farthest(b.centre - a.centre);
  simplex.count = 1;
  for (int round = 0; round < kMostRounds; ++round) {
    const Vector3d nearest = nearestOf(simplex);
    if (simplex.count == 4 || nearest.squaredNorm() < kInside) {
      return true;
    }
    const Vector3d next = farthest(-nearest);
    if (next.dot(nearest) > 0.0) {
      return false;
    }
    simplex.points[static_cast<std::size_t>(simplex.count++)] = next;
  }
  return true;
}

}  // namespace

bool modelsOverlap(const EntityModel& a, const Pose& pose_a, const EntityModel& b, const Pose& pose_b) {
  for (const CollisionShape& shape_a : a.shapes) {
    const PlacedShape placed_a(shape_a, pose_a);
    for (const CollisionShape& shape_b : b.shapes) {
      if (overlap(placed_a, PlacedShape(shape_b, pose_b))) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace swarmanoid::dynamics3d
