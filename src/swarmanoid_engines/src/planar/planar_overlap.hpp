/// Whether two convex shapes of a plane overlap, exactly.
#pragma once

#include "planar/planar_model.hpp"

namespace swarmanoid::planar {

/// Shapes that touch, or sink into each other by no more than this, do not overlap: so bodies can be packed side by
/// side although positions are rounded [m].
constexpr double kContactTolerance = 1e-9;

bool overlap(const PlanarShape& a, const PlanarShape& b);

}  // namespace swarmanoid::planar
