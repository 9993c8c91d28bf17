// Contacts of a cylinder's face with a box's face.
#include <array>
#include <cmath>

#include "dynamics3d/collision/cylinders.hpp"
#include "dynamics3d/collision/placed_solid.hpp"
#include "dynamics3d/collision/surface_contacts.hpp"
#include "dynamics3d/settings.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A face of a box and the opposite disc of a cylinder, in W [m]. Coordinates on the face are along its two edges.
struct Faces {
  Vector3d out = Vector3d::UnitZ();    // of the box
  Vector3d middle = Vector3d::Zero();  // of the box's face
  std::array<Vector3d, 2> edges;       // unit vectors
  Vector2d half = Vector2d::Zero();    // of the box's face
  Vector3d centre = Vector3d::Zero();  // of the disc
  std::array<Vector3d, 2> spokes;      // of the disc, as long as its radius; the first one in the direction of a fall

  Vector2d onFace(const Vector3d& vector) const { return {edges[0].dot(vector), edges[1].dot(vector)}; }
  double depthOf(const Vector3d& point) const { return out.dot(middle - point); }
};

/// Direction in which a cylinder on a face would fall: that of its tilt, or else downhill. It needs a contact there
/// from the first step on: tilting until it gets one would set it rocking.
Vector3d wayToFall(const PlacedSolid& cylinder, const Vector3d& out) {
  constexpr double kTilted = 1e-3;  // rad
  constexpr double kSlope = 1e-6;   // rad
  const Vector3d up = cylinder.axes.col(2);
  const Vector3d deep = up.dot(out) * up - out;
  const Vector3d downhill = out.z() * out - Vector3d::UnitZ();
  const Vector3d on_disc = downhill - up.dot(downhill) * up;
  if (deep.norm() > kTilted || on_disc.norm() < kSlope) {
    return deep.norm() > kSlope ? Vector3d(deep.normalized()) : Vector3d(cylinder.axes.col(0));
  }
  return on_disc.normalized();
}

/// Faces of the solids at their sizes in the model: growth makes contacts early, but carries no load.
Faces facesOf(const PlacedSolid& cylinder, const PlacedSolid& box, int axis, double side) {
  constexpr double kGrowth = kMargin / 2.0;
  Faces faces;
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  faces.out = side * box.axes.col(axis);
  faces.middle = box.centre + box.half[axis] * faces.out;
  faces.edges = {box.axes.col(u), box.axes.col(v)};
  faces.half = Vector2d(box.half[u] - kGrowth, box.half[v] - kGrowth);
  const Vector3d up = cylinder.axes.col(2);
  faces.centre = cylinder.centre - std::copysign(cylinder.half.z(), up.dot(faces.out)) * up;
  const Vector3d spoke = wayToFall(cylinder, faces.out);
  const double radius = cylinder.half.x() - kGrowth;
  faces.spokes = {radius * spoke, radius * up.cross(spoke)};
  return faces;
}

bool isInside(const Vector2d& point, const Vector2d& half) {
  return std::abs(point.x()) <= half.x() && std::abs(point.y()) <= half.y();
}

/// The point of the disc's rim at an angle from the first spoke.
Vector3d onRim(const Faces& faces, double angle) {
  return faces.centre + std::cos(angle) * faces.spokes[0] + std::sin(angle) * faces.spokes[1];
}

/// Visits those of the four ends of the spokes that are over the box's face.
template <class Visit>  // void visit(const Vector3d& point_of_disc)
void visitSpokes(const Faces& faces, Visit visit) {
  for (const Vector3d& spoke : faces.spokes) {
    for (const double side : {1.0, -1.0}) {
      const Vector3d end = faces.centre + side * spoke;
      if (isInside(faces.onFace(end - faces.middle), faces.half)) {
        visit(end);
      }
    }
  }
}

/// Visits the points where the rim crosses the edges of the box's face.
template <class Visit>  // void visit(const Vector3d& point_of_disc)
void visitCrossings(const Faces& faces, Visit visit) {
  const Vector2d centre = faces.onFace(faces.centre - faces.middle);
  for (int edge = 0; edge < 2; ++edge) {
    const Vector2d swing(faces.edges[edge].dot(faces.spokes[0]), faces.edges[edge].dot(faces.spokes[1]));
    for (const double side : {-1.0, 1.0}) {
      const double reach = (side * faces.half[edge] - centre[edge]) / swing.norm();
      if (std::abs(reach) >= 1.0) {
        continue;
      }
      const double middle = std::atan2(swing.y(), swing.x());
      const double spread = std::acos(reach);
      for (const double angle : {middle - spread, middle + spread}) {
        const Vector3d point = onRim(faces, angle);
        if (std::abs(faces.onFace(point - faces.middle)[1 - edge]) <= faces.half[1 - edge]) {
          visit(point);
        }
      }
    }
  }
}

/// Visits the corners of the box's face that are under the disc.
template <class Visit>  // void visit(const Vector3d& point_of_disc)
void visitCovered(const Faces& faces, Visit visit) {
  const Vector3d across = faces.spokes[0].cross(faces.spokes[1]);
  for (int corner = 0; corner < 4; ++corner) {
    const double u = (corner & 1) != 0 ? faces.half.x() : -faces.half.x();
    const double v = (corner & 2) != 0 ? faces.half.y() : -faces.half.y();
    const Vector3d below = faces.middle + u * faces.edges[0] + v * faces.edges[1];
    const Vector3d point = below + across.dot(faces.centre - below) / across.dot(faces.out) * faces.out;
    if ((point - faces.centre).squaredNorm() <= faces.spokes[0].squaredNorm()) {
      visit(point);
    }
  }
}

}  // namespace

int collideFaces(dGeomID geom_a, dGeomID geom_b, dContactGeom* found) {
  constexpr double kFlat = 0.9;        // cosine between the axes: it stands, or is about to
  constexpr double kLookAhead = 4e-3;  // m above the face
  const bool is_first = dGeomGetClass(geom_a) == dCylinderClass;
  const dGeomID other = is_first ? geom_b : geom_a;
  if ((!is_first && dGeomGetClass(geom_b) != dCylinderClass) || dGeomGetClass(other) != dBoxClass) {
    return 0;
  }
  const PlacedSolid cylinder(is_first ? geom_a : geom_b);
  const PlacedSolid box(other);
  int axis = 0;
  const Vector3d along = (box.axes.transpose() * cylinder.axes.col(2)).cwiseAbs();
  if (along.maxCoeff(&axis) < kFlat) {
    return 0;
  }
  const double side = box.axes.col(axis).dot(cylinder.centre - box.centre) < 0.0 ? -1.0 : 1.0;
  const Faces faces = facesOf(cylinder, box, axis, side);
  const double depth = faces.depthOf(faces.centre + faces.spokes[0]);
  const Vector2d centre = faces.onFace(faces.centre - faces.middle);
  const double beside = (centre.cwiseAbs() - faces.half).cwiseMax(0.0).norm();
  if (depth <= 0.0 || depth > faces.spokes[0].norm() - beside) {
    return 0;  // they touch with their sides, if at all
  }
  SurfaceContacts contacts;
  const auto collide = [&](const Vector3d& point) {
    const double depth_there = faces.depthOf(point);
    if (depth_there > -kLookAhead) {
      contacts.add({point, is_first ? faces.out : Vector3d(-faces.out), depth_there});
    }
  };
  // the corners of the common area of the two faces
  visitSpokes(faces, collide);
  visitCrossings(faces, collide);
  visitCovered(faces, collide);
  contacts.keepSpread(4);
  int count = 0;
  for (const SurfaceContact& contact : contacts) {
    found[count++] = geometryOf(contact, geom_a, geom_b);
  }
  return count;
}

}  // namespace swarmanoid::dynamics3d
