#pragma once

#include "swarmanoid_experiment_files/robots/read_urdf.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// Returns whether the joint is revolute or continuous.
bool isTurningJoint(const urdf::Joint& joint);

/// @param frame of the joint's link in the body frame, with all joints at zero
/// @param carrier index of the joint that moves this joint; -1: none
/// @throws ConfigError if the joint has no limits, or its start is outside of them
EntityModel::Joint readJoint(const UrdfFile& urdf, const urdf::Joint& joint, const Mount& frame, int carrier);

}  // namespace swarmanoid
