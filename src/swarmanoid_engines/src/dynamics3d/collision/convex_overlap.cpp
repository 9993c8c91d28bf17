// Uses the Minkowski Portal Refinement of libccd. Its Gilbert-Johnson-Keerthi algorithm is less exact: it reports some
// spheres as separate that overlap by 10 um.
#include "dynamics3d/collision/convex_overlap.hpp"

#include <ccd/ccd.h>

#include <cmath>

#include "dynamics3d/collision/placed_solid.hpp"
#include "dynamics3d/collision/surface_contacts.hpp"

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
  explicit PlacedShape(const PlacedSolid& solid)
      : kind(solid.kind), half(solid.half), centre(solid.centre), axes(solid.axes) {}

  /// The point farthest in a direction.
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

/// Unit of length for libccd, which treats values below 1e-10 as zero, squares of lengths too: the size of the smallest
/// solids.
constexpr double kUnit = 1e-4;  // m

/// Support function for libccd: the point of a placed shape that is farthest in a direction.
void supportOf(const void* shape, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const auto& d = direction->v;
  const Vector3d p = static_cast<const PlacedShape*>(shape)->farthest({d[0], d[1], d[2]}) / kUnit;
  ccdVec3Set(point, p.x(), p.y(), p.z());
}

void centreOf(const void* shape, ccd_vec3_t* centre) {
  const Vector3d c = static_cast<const PlacedShape*>(shape)->centre / kUnit;
  ccdVec3Set(centre, c.x(), c.y(), c.z());
}

ccd_t queryOf() {
  constexpr double kPrecision = 1e-9;  // m
  ccd_t query;
  CCD_INIT(&query);
  query.support1 = supportOf;
  query.support2 = supportOf;
  query.center1 = centreOf;
  query.center2 = centreOf;
  query.mpr_tolerance = kPrecision / kUnit;
  return query;
}

bool overlap(const PlacedShape& a, const PlacedShape& b) {
  const ccd_t query = queryOf();
  return ccdMPRIntersect(&a, &b, &query) != 0;
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

int collideConvex(dGeomID geom_a, dGeomID geom_b, dContactGeom* found) {
  const PlacedShape a{PlacedSolid(geom_a)};
  const PlacedShape b{PlacedSolid(geom_b)};
  const ccd_t query = queryOf();
  ccd_real_t depth = 0.0;
  ccd_vec3_t way;  // of b, out of a
  ccd_vec3_t place;
  if (ccdMPRPenetration(&a, &b, &query, &depth, &way, &place) != 0) {
    return 0;
  }
  const auto vector = [](const ccd_vec3_t& v) { return Vector3d(v.v[0], v.v[1], v.v[2]); };
  *found = geometryOf({kUnit * vector(place), -vector(way).normalized(), kUnit * depth}, geom_a, geom_b);
  return 1;
}

}  // namespace swarmanoid::dynamics3d
