/// Intersection of a ray with a planar shape, extruded to its band of heights.
#pragma once

#include <limits>

#include "planar/planar_model.hpp"

namespace swarmanoid::planar {

/// A ray in the plane's frame: from `from` by `step`, and from height `height` by `climb`.
struct PlanarRay {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d step = Eigen::Vector2d::Zero();
  double height = 0.0;
  double climb = 0.0;
};

constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// Fraction of the ray at which it first hits the shape; 0 if it starts inside, kNoHit if it misses.
/// @param offset is added to the shape's band
double closestHit(const PlanarRay& ray, const PlanarShape& shape, double offset);

}  // namespace swarmanoid::planar
