// Ground contacts of boxes and cylinders.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "dynamics3d/contacts/ground_contacts.hpp"
#include "swarmanoid_space/rays/line_part.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;
using Ridge = GroundSurface::Ridge;
using ShapeKind = CollisionShape::Kind;

/// A face of a solid, in its own frame.
struct Face {
  Vector3d out = Vector3d::Zero();
  double distance = std::numeric_limits<double>::infinity();  // from the solid's centre

  double depthOf(const Vector3d& point) const { return distance - out.dot(point); }
};

/// Among the faces opposed to `ground`, the one through which `point` has the shortest way out of the solid.
/// @param ground out of the ground, in the solid's frame
Face faceOver(ShapeKind kind, const Vector3d& half, const Vector3d& point, const Vector3d& ground) {
  constexpr double kAgainst = 0.2;  // cosine
  Face best;
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](const Vector3d& out, double distance) {
    const double depth = distance - out.dot(point);
    if (out.dot(ground) < -kAgainst && depth < least) {
      least = depth;
      best = {out, distance};
    }
  };
  for (int axis = kind == ShapeKind::kBox ? 0 : 2; axis < 3; ++axis) {
    look(Vector3d::Unit(axis), half[axis]);
    look(-Vector3d::Unit(axis), half[axis]);
  }
  const double across = point.head<2>().norm();
  if (kind == ShapeKind::kCylinder && across > 0.0) {
    look(Vector3d(point.x() / across, point.y() / across, 0.0), half.x());
  }
  return best;
}

}  // namespace

void collideCorners(const GroundSurface& ground, const PlacedSolid& box, double margin, SurfaceContacts& contacts) {
  for (int i = 0; i < 8; ++i) {
    const Vector3d signs((i & 1) != 0 ? 1.0 : -1.0, (i & 2) != 0 ? 1.0 : -1.0, (i & 4) != 0 ? 1.0 : -1.0);
    collidePoint(ground, box.centre + box.axes * box.half.cwiseProduct(signs), 0.0, margin, contacts);
  }
}

void collideRims(const GroundSurface& ground, const PlacedSolid& cylinder, double margin, SurfaceContacts& contacts) {
  constexpr int kPlaces = 8;  // around a face, so that it can stand
  const Vector3d axis = cylinder.axes.col(2);
  const auto collideAt = [&](const Vector3d& across) {
    for (const double side : {-1.0, 1.0}) {
      collidePoint(ground, cylinder.centre + side * cylinder.half.z() * axis + across, 0.0, margin, contacts);
    }
  };
  // the rims' lowest points over each slope
  Vector3d last = Vector3d::Zero();
  const auto collideDeepest = [&](const GroundSurface::Triangle& triangle) {
    const Vector3d across = triangle.normal - triangle.normal.dot(axis) * axis;
    if (triangle.normal != last && across.norm() > 1e-9) {
      collideAt(-cylinder.half.x() * across.normalized());
    }
    last = triangle.normal;
  };
  ground.visitTriangles(cylinder.bounds(), collideDeepest);
  ground.visitCliffs(cylinder.bounds(), collideDeepest);
  for (int i = 0; i < kPlaces; ++i) {
    const double angle = 2.0 * M_PI * i / kPlaces;
    collideAt(cylinder.half.x() * (std::cos(angle) * cylinder.axes.col(0) + std::sin(angle) * cylinder.axes.col(1)));
  }
}

void collideRidges(const GroundSurface& ground, const PlacedSolid& solid, double margin, SurfaceContacts& contacts) {
  const Vector3d half = solid.half.array() + margin;
  ground.visitRidges(solid.bounds(), [&](const Ridge& ridge) {
    const Vector3d start = solid.axes.transpose() * (ridge.from - solid.centre);
    const Vector3d way = solid.axes.transpose() * (ridge.to - ridge.from);
    LinePart part;
    part.clipToSlab(start.z(), way.z(), -half.z(), half.z());
    if (solid.kind == ShapeKind::kBox) {
      part.clipToSlab(start.x(), way.x(), -half.x(), half.x());
      part.clipToSlab(start.y(), way.y(), -half.y(), half.y());
    } else {
      part.clipToRound(Eigen::Vector2d(start.head<2>()), Eigen::Vector2d(way.head<2>()), half.x());
    }
    if (part.isEmpty()) {
      return;
    }
    const Vector3d middle = start + 0.5 * (part.from + part.to) * way;
    const Face face = faceOver(solid.kind, half, middle, solid.axes.transpose() * ridge.out);
    for (const double at : {part.from, part.to}) {
      const double depth = face.depthOf(start + at * way);
      if (depth > 0.0 && depth < half.maxCoeff()) {
        contacts.add({ridge.from + at * (ridge.to - ridge.from), -(solid.axes * face.out), depth});
      }
    }
  });
}

}  // namespace swarmanoid::dynamics3d
