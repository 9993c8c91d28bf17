/// The parameters of entities.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid::experiment {

/// Placement of an entity, without a position in a distribution.
std::vector<Parameter> placementParameters(bool is_distributed);
/// Target pose of an entity: position, then orientation, both required.
std::vector<Parameter> poseParameters();
/// Parameters of an entity: those of its type and its placement, without a position in a distribution.
std::vector<Parameter> entityParameters(const PluginDescription& type, bool is_distributed);

}  // namespace swarmanoid::experiment
