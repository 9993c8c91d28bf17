/// What all engines ask of the mechanisms of an entity that they are to move.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/engine.hpp"

namespace swarmanoid {

/// Why such an entity cannot be moved with these devices: it has no shape, not the mechanisms that they work with, or
/// two of them would drive it, or command the same joint or holder; "" if nothing speaks against it.
std::string unsupportedMechanismsReason(const EntityModel& model, const std::vector<DeviceUse>& devices);

/// Whether a device works with a joint or a holder of that name.
bool worksWith(const DeviceUse& device, Mechanism::Kind kind, const std::string& name);

}  // namespace swarmanoid
