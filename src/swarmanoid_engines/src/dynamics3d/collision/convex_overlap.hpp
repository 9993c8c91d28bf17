/// Overlap of solids: a test for placing entities, and a contact.
#pragma once

#include "dynamics3d/ode.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid::dynamics3d {

/// Shapes that touch, or overlap by no more than this, do not count as overlapping [m].
constexpr double kContactTolerance = 1e-6;

/// Exact to 1e-9 m except for the tolerance, and symmetric.
bool modelsOverlap(const EntityModel& a, const Pose& pose_a, const EntityModel& b, const Pose& pose_b);

/// The contact of two geoms at their deepest point, for pairs whose own test may find none.
/// @param found array of one @return 1; 0 if they do not overlap
int collideConvex(dGeomID a, dGeomID b, dContactGeom* found);

}  // namespace swarmanoid::dynamics3d
