/// Hits of a segment on the solids of an entity's model: for entities in no engine, and for engines without shapes of
/// their own for rays.
#pragma once

#include <Eigen/Core>

#include "swarmanoid_space/rays/ray.hpp"
#include "swarmanoid_space/state/entities.hpp"

namespace swarmanoid {

/// The fraction of `segment` at which it first hits the entity's shapes; more than 1 if it hits none. Thread-safe.
double closestHit(const Segment& segment, const EntityModel& model, const Pose& pose);

}  // namespace swarmanoid
