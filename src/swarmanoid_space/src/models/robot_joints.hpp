#pragma once

#include "read_urdf.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// Whether it is revolute or continuous.
bool isTurningJoint(const urdf::Joint& joint);

/// @param frame of the joint's link in the body frame, with all joints at zero
/// @param carrier the index of the joint that turns what carries this one; -1: none
/// @throws ConfigError if it has no limits, or starts outside of them
EntityModel::Joint readJoint(const UrdfFile& urdf, const urdf::Joint& joint, const Mount& frame, int carrier);

}  // namespace swarmanoid
