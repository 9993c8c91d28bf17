/// An entity's shapes as a plane sees them: circles and convex polygons, each with the band of heights it fills.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "planar/plane.hpp"
#include "swarmanoid_space/entity_model.hpp"

namespace swarmanoid::planar {

/// Heights along the plane's normal [m].
struct Band {
  double low = 0.0;
  double high = 0.0;

  /// Bands that only touch do not meet: a box may stand on a table.
  bool meets(const Band& other, double my_offset, double other_offset) const {
    return low + my_offset < other.high + other_offset && other.low + other_offset < high + my_offset;
  }
};

/// A circle (no vertices) or a convex polygon (counter-clockwise vertices), in the body's or the plane's frame.
struct PlanarShape {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of a circle, or the middle of the vertices
  double radius = 0.0;  ///< of the circle, or of one around `centre` that holds the polygon
  std::vector<Eigen::Vector2d> vertices;
  Band band;

  bool isCircle() const { return vertices.empty(); }
};

struct PlanarModel {
  std::vector<PlanarShape> shapes;  ///< at heading 0, around the body's origin
  double radius = 0.0;              ///< of a circle around the origin that holds all shapes [m]
  Band band;                        ///< of all shapes, relative to the origin
};

/// Projects the shapes of an entity whose orientation at heading 0 is `base`.
std::shared_ptr<const PlanarModel> projectModel(const EntityModel& model, const Plane& plane,
                                                const Eigen::Quaterniond& base);

/// Puts a model's shapes where a body is. `placed` is of the model's shape count and keeps its memory.
void placeShapes(const PlanarModel& model, const Eigen::Vector2d& position, double cosine, double sine,
                 std::vector<PlanarShape>& placed);

}  // namespace swarmanoid::planar
