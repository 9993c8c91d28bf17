#include "dynamics3d/collision/placed_solid.hpp"

#include <cmath>

namespace swarmanoid::dynamics3d {

PlacedSolid::PlacedSolid(dGeomID geom) : centre(toVector(dGeomGetPosition(geom))) {
  const dReal* rotation = dGeomGetRotation(geom);
  for (int i = 0; i < 3; ++i) {
    axes.row(i) = toVector(rotation + 4 * i).transpose();
  }
  if (dGeomGetClass(geom) == dBoxClass) {
    kind = CollisionShape::Kind::kBox;
    dVector3 lengths;
    dGeomBoxGetLengths(geom, lengths);
    half = 0.5 * toVector(lengths);
  } else if (dGeomGetClass(geom) == dCylinderClass) {
    kind = CollisionShape::Kind::kCylinder;
    dReal radius = 0.0;
    dReal length = 0.0;
    dGeomCylinderGetParams(geom, &radius, &length);
    half = {radius, radius, 0.5 * length};
  } else {
    half.setConstant(dGeomSphereGetRadius(geom));
  }
}

PlacedSolid::PlacedSolid(const CollisionShape& shape, const Pose& body)
    : kind(shape.kind),
      half(shape.half_extent),
      centre(body.toWorld(shape.position)),
      axes((body.orientation * shape.orientation).toRotationMatrix()) {}

Eigen::AlignedBox3d PlacedSolid::bounds() const {
  Eigen::Vector3d reach = Eigen::Vector3d::Constant(half.x());
  if (kind == CollisionShape::Kind::kBox) {
    reach = axes.cwiseAbs() * half;
  } else if (kind == CollisionShape::Kind::kCylinder) {
    for (int i = 0; i < 3; ++i) {
      reach[i] = half.x() * std::hypot(axes(i, 0), axes(i, 1)) + half.z() * std::abs(axes(i, 2));
    }
  }
  return {centre - reach, centre + reach};
}

}  // namespace swarmanoid::dynamics3d
