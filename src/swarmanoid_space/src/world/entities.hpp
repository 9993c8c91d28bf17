/// Adding entities to a running world and taking them out of it: decide first, then commit.
#pragma once

#include <memory>
#include <vector>

#include "swarmanoid_interface/orientation.hpp"
#include "world.hpp"

namespace swarmanoid {

/// @throws ConfigError if the entity cannot be there, in one of the engines
void refuseBadPlace(const World& world, const EntityDescription& entity, const EntityModel& model, const Pose& pose,
                    const std::vector<Membership>& memberships);

/// @throws ConfigError (a bad place, a name that is taken, a controller that does not start); then nothing has changed
Row addEntity(World& world, const EntityDescription& entity, const std::vector<Membership>& memberships);

/// The same where it is known that nothing is in its way. @param model of the entity, as modelOf makes it
Row addFreeEntity(World& world, const EntityDescription& entity, const std::shared_ptr<const EntityModel>& model,
                  const std::vector<Membership>& memberships);

std::shared_ptr<const EntityModel> modelOf(const EntityDescription& entity);
inline Pose poseOf(const EntityDescription& entity) { return {entity.position, orientationFromAngles(entity.angles)}; }

void removeEntity(World& world, Row row);

/// What the controller throws is a failure, and an event of the next tick.
void destroyController(World& world, RobotInstance& instance);

}  // namespace swarmanoid
