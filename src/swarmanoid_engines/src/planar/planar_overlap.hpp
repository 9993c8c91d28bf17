/// Whether two convex shapes of a plane overlap, exactly.
#pragma once

#include "planar/planar_model.hpp"

namespace swarmanoid::planar {

/// Touching is no overlap, see kContactTolerance. Heights are not looked at.
bool overlap(const PlanarShape& a, const PlanarShape& b);

}  // namespace swarmanoid::planar
