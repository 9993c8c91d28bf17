/// Whether, and how far, two convex shapes of a plane overlap, exactly.
#pragma once

#include "planar/planar_model.hpp"

namespace swarmanoid::planar {

/// Touching is no overlap, see kContactTolerance. Heights are not looked at.
bool overlap(const PlanarShape& a, const PlanarShape& b);

/// How a shape gets free of another by the shortest way.
struct Penetration {
  double depth = 0.0;                                 ///< 0 or less: they do not overlap [m]
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  ///< unit vector, out of the other shape
};

/// The way of `a` out of `b`: the least depth over all directions for polygons, along the line of centres for circles.
/// Shapes that do not overlap have a depth of kContactTolerance or less.
Penetration penetration(const PlanarShape& a, const PlanarShape& b);

}  // namespace swarmanoid::planar
