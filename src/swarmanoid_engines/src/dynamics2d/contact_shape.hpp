/// Shapes of a body for contacts: circles and convex polygons in double precision, and the same polygons in the format
/// of Box2D.
///
/// Frame: the body's centre of mass, at heading 0. Units: metres.
#pragma once

#include <box2d/b2_polygon_shape.h>

#include <Eigen/Core>
#include <array>
#include <vector>

#include "planar/planar_model.hpp"

namespace swarmanoid::dynamics2d {

/// The thinnest shape that a body may have [m]. @see Dynamics2d::unsupportedReason
constexpr double kThinnest = 1e-3;

/// A circle, or a convex polygon of at most as many corners as Box2D allows.
struct ContactShape {
  static constexpr int kMostCorners = b2_maxPolygonVertices;
  using Corners = std::array<Eigen::Vector2d, kMostCorners>;
  static Corners noCorners() {
    Corners none;
    none.fill(Eigen::Vector2d::Zero());
    return none;
  }
  static b2PolygonShape noPolygon() {
    b2PolygonShape none;
    for (int i = 0; i < kMostCorners; ++i) {
      none.m_vertices[i].SetZero();
      none.m_normals[i].SetZero();
    }
    return none;
  }

  bool is_circle = false;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of the circle, or mean of the corners
  double radius = 0.0;                   ///< of the circle, or of one around `centre` that holds the polygon
  int count = 0;                         ///< of corners
  Corners corners = noCorners();         ///< counter-clockwise
  Corners normals = noCorners();         ///< outwards; index i: of the side from corner i to the next
  b2PolygonShape polygon = noPolygon();  ///< the polygon in Box2D's single precision
  planar::Band band;                     ///< of heights, relative to the body's origin
  std::size_t number = 0;                ///< of the shape in the body's model
};

/// Replaces `shapes` by those of a model, reusing their memory. Polygons with more corners than Box2D allows are split
/// into several that share sides. Corners within a micrometre of the line between their neighbours are left out, so
/// that sides have a direction and no assertion of Box2D is reached, whatever the model. @param arm from the origin to
/// the centre of mass
void makeContactShapes(const planar::PlanarModel& model, const Eigen::Vector2d& arm, std::vector<ContactShape>& shapes);

}  // namespace swarmanoid::dynamics2d
