#include "dynamics3d/collision/cylinders.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics3d/collision/surface_contacts.hpp"
#include "dynamics3d/settings.hpp"

namespace swarmanoid::dynamics3d {
namespace {

struct Cylinder {
  explicit Cylinder(dGeomID geom) : centre(toVector(dGeomGetPosition(geom))) {
    const dReal* rotation = dGeomGetRotation(geom);
    axis = {rotation[2], rotation[6], rotation[10]};
    spoke = {rotation[0], rotation[4], rotation[8]};
    dReal length = 0.0;
    dGeomCylinderGetParams(geom, &radius, &length);
    half_length = length / 2.0;
  }
  /// The point of the axis at a height along another axis.
  Eigen::Vector3d at(double height, const Eigen::Vector3d& along) const {
    return centre + (height - along.dot(centre)) / along.dot(axis) * axis;
  }

  Eigen::Vector3d centre;
  Eigen::Vector3d axis;
  Eigen::Vector3d spoke;  // a direction across the axis, fixed to the cylinder
  double radius = 0.0;
  double half_length = 0.0;
};

}  // namespace

int collidePlane(dGeomID geom, dGeomID plane, dContactGeom* found) {
  constexpr double kFlat = 0.9;        // cosine between axis and normal: it stands, or is about to
  constexpr double kLookAhead = 4e-3;  // m above the plane
  constexpr double kGrowth = kMargin / 2.0;
  if (dGeomGetClass(geom) != dCylinderClass) {
    return 0;
  }
  const Cylinder cylinder(geom);
  dVector4 equation;
  dGeomPlaneGetParams(plane, equation);
  const Eigen::Vector3d normal = toVector(equation);
  const double along = normal.dot(cylinder.axis);
  // at the size of the solid in the model: growth makes contacts early, but carries no load
  const double radius = cylinder.radius - kGrowth;
  const Eigen::Vector3d face = -std::copysign(cylinder.half_length - kGrowth, along) * cylinder.axis;  // the lower one
  Eigen::Vector3d down = along * cylinder.axis - normal;
  const double slant = down.norm();
  down = slant > 1e-9 ? Eigen::Vector3d(down / slant) : cylinder.spoke;
  const bool is_flat = std::abs(along) > kFlat;
  const Eigen::Vector3d across = radius * cylinder.axis.cross(down);
  const Eigen::Vector3d other_end =
      is_flat ? Eigen::Vector3d(face - radius * down) : Eigen::Vector3d(radius * down - face);
  const Eigen::Vector3d points[4] = {face + radius * down, other_end, face + across, face - across};
  int count = 0;
  for (int i = 0; i < (is_flat ? 4 : 2); ++i) {
    const Eigen::Vector3d point = cylinder.centre + points[i];
    const double depth = equation[3] - normal.dot(point) + kGrowth;
    if (depth > -kLookAhead) {
      found[count++] = geometryOf({point, normal, depth}, geom, plane);
    }
  }
  return count;
}

int collideSides(dGeomID geom_a, dGeomID geom_b, dContactGeom* found) {
  constexpr double kParallel = 0.98;  // cosine of 11 degrees
  constexpr double kStanding = 0.02;  // m: with more common height, they came from the side, or were placed there
  constexpr double kFacing = 2e-3;    // m: cylinders with less common height touch with their edges
  if (dGeomGetClass(geom_a) != dCylinderClass || dGeomGetClass(geom_b) != dCylinderClass) {
    return 0;
  }
  const Cylinder a(geom_a);
  const Cylinder b(geom_b);
  const double cosine = a.axis.dot(b.axis);
  if (std::abs(cosine) < kParallel) {
    return 0;
  }
  const Eigen::Vector3d along = (a.axis + std::copysign(1.0, cosine) * b.axis).normalized();
  const double height_a = along.dot(a.centre);
  const double height_b = along.dot(b.centre);
  const double low = std::max(height_a - a.half_length, height_b - b.half_length);
  const double high = std::min(height_a + a.half_length, height_b + b.half_length);
  if (high - low < kFacing) {
    return 0;
  }
  const double reach = a.radius + b.radius;
  const Eigen::Vector3d between_centres = a.at(0.5 * (low + high), along) - b.at(0.5 * (low + high), along);
  if (high - low < kStanding && reach - between_centres.norm() > high - low) {
    return 0;  // one stands on the other
  }
  int count = 0;
  for (const double height : {low, high}) {
    const Eigen::Vector3d on_a = a.at(height, along);
    const Eigen::Vector3d way = on_a - b.at(height, along);
    const double distance = way.norm();
    if (distance >= reach || distance == 0.0) {
      continue;
    }
    const Eigen::Vector3d normal = way / distance;
    const double depth = reach - distance;
    const Eigen::Vector3d point = on_a - (a.radius - 0.5 * depth) * normal;
    found[count++] = geometryOf({point, normal, depth}, geom_a, geom_b);
  }
  return count;
}

}  // namespace swarmanoid::dynamics3d
