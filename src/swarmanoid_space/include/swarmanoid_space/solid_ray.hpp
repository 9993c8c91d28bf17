/// Where a segment meets the solids of an entity, as they are: for entities in no engine, and for engines that have no
/// shapes of their own to cast rays against.
#pragma once

#include "swarmanoid_space/entities.hpp"
#include "swarmanoid_space/ray.hpp"

namespace swarmanoid {

/// The fraction of `segment` at which it first meets the entity's shapes; more than 1 if it does not. Thread-safe.
double firstMeeting(const Segment& segment, const EntityModel& model, const Pose& pose);

}  // namespace swarmanoid
