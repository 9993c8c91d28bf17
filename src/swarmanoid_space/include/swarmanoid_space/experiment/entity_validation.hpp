/// Validation of entities. Files, --set, services and code all use these functions, so the same rules hold for all of
/// them. Limits are in limits.hpp.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/models/entity_model.hpp"

namespace swarmanoid::validation {

/// Returns whether the text is a valid name. Names become parts of files, topics and frames: letters, digits and _, a
/// letter first.
bool isName(const std::string& text);
constexpr const char* kNamesAllowed = "letters, digits and _, a letter first";

/// Checks type, values, placement and controller of an entity, or of a distribution of entities.
/// @param experiment describes the arena and the controllers
/// @throws ConfigError, with the location of the value if it has one
void check(const EntityDescription& entity, const Experiment& experiment);

/// Checks an initial position. A movable entity must start inside the arena; a fixed one, such as a wall, may be
/// outside.
/// @param what name of the position in messages
/// @throws ConfigError
void checkPosition(const std::string& what, const Eigen::Vector3d& position, const EntityModel& model,
                   const ArenaDescription& arena, const SourceLocation& location);

}  // namespace swarmanoid::validation
