// Contacts of balls, and of points, which are balls of radius zero.
#include <algorithm>
#include <cmath>

#include "dynamics3d/contacts/ground_contacts.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;
using Triangle = GroundSurface::Triangle;

/// The point of the side from `a` to `b` that is nearest to `point`.
Vector3d nearestOfSide(const Vector3d& a, const Vector3d& b, const Vector3d& point) {
  const Vector3d side = b - a;
  const double length = side.squaredNorm();
  return length > 0.0 ? Vector3d(a + std::clamp(side.dot(point - a) / length, 0.0, 1.0) * side) : a;
}

Vector3d nearestOf(const Triangle& triangle, const Vector3d& point) {
  const auto& corners = triangle.corners;
  const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  bool is_inside = normal.squaredNorm() > 0.0;
  for (int i = 0; i < 3 && is_inside; ++i) {
    const Vector3d& a = corners[i];
    const Vector3d& b = corners[(i + 1) % 3];
    is_inside = normal.dot((b - a).cross(point - a)) >= 0.0;
  }
  if (is_inside) {
    return point - triangle.normal.dot(point - corners[0]) * triangle.normal;
  }
  Vector3d nearest = nearestOfSide(corners[2], corners[0], point);
  for (int i = 0; i < 2; ++i) {
    const Vector3d other = nearestOfSide(corners[i], corners[i + 1], point);
    if ((other - point).squaredNorm() < (nearest - point).squaredNorm()) {
      nearest = other;
    }
  }
  return nearest;
}

/// Whether `point` is the nearest point to `centre` on all parts of the surface that meet in it; otherwise it is on a
/// seam.
bool isNearest(const GroundSurface& ground, const Vector3d& point, const Vector3d& centre) {
  constexpr double kTouch = 1e-8;  // m
  constexpr double kSame = 1e-7;   // m
  const Vector3d reach = Vector3d::Constant(kTouch);
  bool is_nearest = true;
  const auto look = [&](const Triangle& triangle) {
    is_nearest = is_nearest && ((nearestOf(triangle, point) - point).norm() > kTouch ||
                                (nearestOf(triangle, centre) - point).norm() < kSame);
  };
  ground.visitTriangles({point - reach, point + reach}, look);
  ground.visitCliffs({point - reach, point + reach}, look);
  const auto level = ground.levelAt(centre);
  return is_nearest && !(level && std::abs(point.z() - *level) < kTouch && (point - centre).head<2>().norm() > kSame);
}

}  // namespace

void collidePoint(const GroundSurface& ground, const Vector3d& point, double radius, double margin,
                  SurfaceContacts& contacts) {
  const auto column = ground.columnAt(point);
  if (!column) {
    return;
  }
  const double over = (point.z() - column->height) * column->normal.z();
  if (over >= radius + margin) {
    return;
  }
  SurfaceContact contact{point - radius * column->normal, column->normal, radius + margin - over};
  if (over < 0.0) {
    const Vector3d reach = Vector3d::Constant(-over);
    ground.visitCliffs({point - reach, point + reach}, [&](const Triangle& cliff) {
      const Vector3d nearest = nearestOf(cliff, point);
      const double distance = (nearest - point).norm();
      if (cliff.normal.dot(nearest - point) > 0.0 && radius + margin + distance < contact.depth) {
        contact = {point - radius * cliff.normal, cliff.normal, radius + margin + distance};
      }
    });
  }
  contacts.add(contact);
}

void collideBall(const GroundSurface& ground, const PlacedSolid& ball, double margin, SurfaceContacts& contacts) {
  constexpr double kBehind = 1e-9;
  const Vector3d& centre = ball.centre;
  const double radius = ball.half.x();
  const double reach = radius + margin;
  const auto column = ground.columnAt(centre);
  if (column && centre.z() < column->height) {
    collidePoint(ground, centre, radius, margin, contacts);
    return;
  }
  const auto collide = [&](const Triangle& triangle) {
    const Vector3d nearest = nearestOf(triangle, centre);
    const double distance = (centre - nearest).norm();
    if (distance >= reach || triangle.normal.dot(centre - nearest) <= kBehind * distance) {
      return;
    }
    const Vector3d normal = (centre - nearest) / distance;
    if (isNearest(ground, nearest, centre)) {
      contacts.add({centre - radius * normal, normal, reach - distance});
    }
  };
  const Vector3d around = Vector3d::Constant(reach);
  const Eigen::AlignedBox3d box(centre - around, centre + around);
  ground.visitTriangles(box, collide);
  ground.visitCliffs(box, collide);
  const auto level = ground.levelAt(centre);
  if (level && centre.z() - *level < reach) {
    contacts.add({centre - radius * Vector3d::UnitZ(), Vector3d::UnitZ(), reach - (centre.z() - *level)});
  }
}

}  // namespace swarmanoid::dynamics3d
