#pragma once

#include "read_urdf.hpp"
#include "robot_description.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// The differential drive that two joints make (continuous, axis y, with a limit of velocity; the widest cylinder of
/// each joint's link is the wheel).
/// @param model its mounts are read
/// @throws ConfigError if they make none that can be simulated
EntityModel::Wheels readWheels(const UrdfFile& urdf, const EntityModel& model, const RobotDescription::Wheels& joints);

}  // namespace swarmanoid
