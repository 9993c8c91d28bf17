/// Bounding box of an entity.
#pragma once

#include <Eigen/Geometry>

#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

/// Returns a box in W around the shapes of an entity, valid for all positions of its joints.
Eigen::AlignedBox3d boundsOf(const EntityModel& model, const Pose& pose);

}  // namespace swarmanoid
