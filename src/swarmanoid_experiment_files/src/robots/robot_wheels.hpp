#pragma once

#include "robot_description.hpp"
#include "swarmanoid_experiment_files/robots/read_urdf.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// Reads the differential drive that two joints form (continuous, axis y, with a velocity limit; the widest cylinder of
/// each joint's link is the wheel).
/// @param model provides its mounts
/// @throws ConfigError if the joints do not form a drive that can be simulated
EntityModel::Wheels readWheels(const UrdfFile& urdf, const EntityModel& model, const RobotDescription::Wheels& joints);

}  // namespace swarmanoid
