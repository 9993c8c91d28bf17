/// Where a segment hits the solids of an entity, as they are: for entities in no engine, and for engines that have no
/// shapes of their own to cast rays against.
#pragma once

#include <Eigen/Core>

#include "swarmanoid_space/rays/ray.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

/// The fraction of `segment` at which it first hits the entity's shapes; more than 1 if it does not. Thread-safe.
double closestHit(const Segment& segment, const EntityModel& model, const Pose& pose);

}  // namespace swarmanoid
