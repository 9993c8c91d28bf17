/// Whether solids overlap, for placing entities.
#pragma once

#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid::dynamics3d {

/// Shapes that touch, or sink into each other by no more than this, do not overlap [m].
constexpr double kContactTolerance = 1e-6;

/// Exact to 1e-9 m but for the tolerance, and the same whichever comes first.
bool modelsOverlap(const EntityModel& a, const Pose& pose_a, const EntityModel& b, const Pose& pose_b);

}  // namespace swarmanoid::dynamics3d
