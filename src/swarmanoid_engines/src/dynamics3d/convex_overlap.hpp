/// Whether solids overlap, for placing entities, and how deep.
#pragma once

#include "dynamics3d/ode.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid::dynamics3d {

/// Shapes that touch, or sink into each other by no more than this, do not overlap [m].
constexpr double kContactTolerance = 1e-6;

/// Exact to 1e-9 m but for the tolerance, and the same whichever comes first.
bool modelsOverlap(const EntityModel& a, const Pose& pose_a, const EntityModel& b, const Pose& pose_b);

/// One contact of two geoms where they are deepest in each other: for pairs whose own test may find none.
/// @param found room for one @return 1; 0 if they do not overlap
int collideConvex(dGeomID a, dGeomID b, dContactGeom* found);

}  // namespace swarmanoid::dynamics3d
