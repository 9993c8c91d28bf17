/// Exact test and depth of the overlap of two convex shapes in a plane.
#pragma once

#include "planar/planar_model.hpp"

namespace swarmanoid::planar {

/// Touching shapes do not overlap, see kContactTolerance. Ignores heights.
bool overlap(const PlanarShape& a, const PlanarShape& b);

/// The shortest way of a shape out of another.
struct Penetration {
  double depth = 0.0;                                 ///< 0 or less if they do not overlap [m]
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< unit vector, pointing out of the other shape
};

/// The shortest way of `a` out of `b`: the least depth over all directions for polygons, along the line of centres for
/// circles. Shapes that do not overlap have a depth of kContactTolerance or less.
Penetration penetration(const PlanarShape& a, const PlanarShape& b);

}  // namespace swarmanoid::planar
