/// Where a segment meets the solids of an entity that is in no engine.
#pragma once

#include "swarmanoid_space/entities.hpp"
#include "swarmanoid_space/ray.hpp"

namespace swarmanoid {

/// The fraction of `segment` at which it first meets the entity's shapes; more than 1 if it does not.
double firstMeeting(const Segment& segment, const EntityModel& model, const Pose& pose);

}  // namespace swarmanoid
