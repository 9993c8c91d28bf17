/// What all engines ask of the devices of an entity that they are to move.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid {

/// Why such an entity cannot be moved with these devices: it lacks shapes, wheels, a gripper or a turret, or two
/// devices would drive it; "" if nothing speaks against it.
std::string unsupportedDevicesReason(const EntityModel& model, const std::vector<std::string>& devices);

}  // namespace swarmanoid
