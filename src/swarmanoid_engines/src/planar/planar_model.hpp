/// Shapes of an entity, projected to a plane: circles and convex polygons, each with its band of heights.
///
/// Spheres, and cylinders along the normal, become circles; all other shapes become their outline (boxes along the
/// axes: rectangles). The outline of a lying cylinder is that of a ring of points around each face. Threads: the
/// functions may run concurrently.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "planar/plane.hpp"
#include "swarmanoid_space/state/joints.hpp"

namespace swarmanoid::planar {

/// Shapes that touch, or overlap by no more than this, do not count as overlapping [m]. So bodies can be packed side by
/// side or stacked in spite of rounding.
constexpr double kContactTolerance = 1e-9;

/// Heights along the plane's normal [m].
struct Band {
  double low = 0.0;
  double high = 0.0;

  /// Bands that only touch do not overlap, so that a box may stand on a table.
  bool overlaps(const Band& other, double my_offset, double other_offset) const {
    return low + my_offset < other.high + other_offset - kContactTolerance &&
           other.low + other_offset < high + my_offset - kContactTolerance;
  }
};

/// A circle (no vertices) or a convex polygon (counter-clockwise vertices), in the body's or the plane's frame.
struct PlanarShape {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of a circle; for polygons the projected centre of the shape
  double radius = 0.0;  ///< of the circle, or of a circle around `centre` that holds the polygon
  std::vector<Eigen::Vector2d> vertices;
  Band band;

  bool isCircle() const { return vertices.empty(); }
};

struct PlanarModel {
  std::vector<PlanarShape> shapes;  ///< at heading 0, around the body's origin
  double radius = 0.0;              ///< of a circle around the origin that holds all shapes [m]
  double inner_radius = 0.0;        ///< of the largest circle around a shape's centre that lies in the shape [m]
  Band band;                        ///< of all shapes, relative to the origin

  // Body axes at heading 0, projected to the plane; `turn` is the component of body z along the normal.
  Eigen::Vector2d ahead = Eigen::Vector2d::UnitX();
  Eigen::Vector2d left = Eigen::Vector2d::UnitY();
  Eigen::Vector2d up = Eigen::Vector2d::Zero();
  double turn = 1.0;
};

/// Projects an entity whose orientation at heading 0 is `base`. `result` keeps its memory.
/// @param joints states of the model's joints; empty: all are at zero
void projectModel(const EntityModel& model, const Plane& plane, const Eigen::Quaterniond& base, PlanarModel& result,
                  Span<const JointState> joints = {});

/// The convex hull of points, counter-clockwise, without duplicate or nearly straight corners. Reorders `points`;
/// `hull` keeps its memory.
void findConvexHull(std::vector<Eigen::Vector2d>& points, std::vector<Eigen::Vector2d>& hull);

/// Transforms a shape of a model to a body's pose. `placed` keeps its memory.
void placeShape(const PlanarShape& shape, const Eigen::Vector2d& position, double cosine, double sine,
                PlanarShape& placed);

/// As placeShape, for all shapes of a model. `placed` has at least that many elements afterwards, and keeps its memory.
void placeShapes(const PlanarModel& model, const Eigen::Vector2d& position, double cosine, double sine,
                 std::vector<PlanarShape>& placed);

}  // namespace swarmanoid::planar
