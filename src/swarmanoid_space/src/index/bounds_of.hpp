/// A box around an entity.
#pragma once

#include <Eigen/Geometry>

#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

/// Of an entity's shapes, in W, whatever its joints do.
Eigen::AlignedBox3d boundsOf(const EntityModel& model, const Pose& pose);

}  // namespace swarmanoid
