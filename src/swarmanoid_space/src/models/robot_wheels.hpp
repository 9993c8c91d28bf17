#pragma once

#include <optional>
#include <string>

#include "read_urdf.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

bool isWheelJoint(const std::string& name);

/// The differential drive that the joints `left_wheel` and `right_wheel` make; nothing if there are none.
/// @param model its mounts are read
/// @throws ConfigError if they make none that can be simulated
std::optional<EntityModel::Wheels> readWheels(const UrdfFile& urdf, const EntityModel& model);

}  // namespace swarmanoid
