/// Requirements of all engines on the mechanisms of an entity.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/engine.hpp"

namespace swarmanoid {

/// Reason why an engine cannot move such an entity with these devices, or "". The entity must have a shape and the
/// mechanisms of all its devices; only one device may drive it, and no two may command the same joint or holder.
std::string unsupportedMechanismsReason(const EntityModel& model, const std::vector<DeviceUse>& devices);

/// Whether a device works with the joint or holder of that name.
bool worksWith(const DeviceUse& device, Mechanism::Kind kind, const std::string& name);

}  // namespace swarmanoid
