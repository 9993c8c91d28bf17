/// The door of the space: what an entity must be, wherever it comes from. Files, --set, services and code all come
/// through here, so that what one of them may not do no other can. Limits are in limits.hpp.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid::door {

/// Names end up in files, topics and frames: letters, digits and _, a letter first.
bool isName(const std::string& text);
constexpr const char* kNamesAllowed = "letters, digits and _, a letter first";

/// Checks type, values, placement and controller of an entity, or of a distribution of them.
/// @param experiment where its arena and its controllers are described
/// @throws ConfigError, at the place of the value if it has one
void check(const EntityDescription& entity, const Experiment& experiment);

/// What can move must be within the arena when it comes in; what stands, such as a wall, may stand around it.
/// @param what the position is called in messages
/// @throws ConfigError
void checkPosition(const std::string& what, const Eigen::Vector3d& position, const EntityModel& model,
                   const ArenaDescription& arena, const SourceLocation& location);

}  // namespace swarmanoid::door
