/// Adds entities to a running world and removes them: decide first, then commit.
#pragma once

#include <memory>
#include <vector>

#include "swarmanoid_interface/orientation.hpp"
#include "world.hpp"

namespace swarmanoid {

/// @param ignored entities that it may overlap, such as itself
/// @throws ConfigError if the entity cannot have the pose in one of the engines
void refuseBadPlace(const World& world, const EntityDescription& entity, const EntityModel& model, const Pose& pose,
                    const std::vector<Membership>& memberships, Span<const Row> ignored);

/// @throws ConfigError (a bad place, a name in use, a controller that does not start); then nothing has changed
Row addEntity(World& world, const EntityDescription& entity, const std::vector<Membership>& memberships);

/// As addEntity, without the check for overlaps. @pre the place is free @param model of the entity, from modelOf
Row addFreeEntity(World& world, const EntityDescription& entity, const std::shared_ptr<const EntityModel>& model,
                  const std::vector<Membership>& memberships);

/// As addFreeEntity, with a row, a number and an exact pose of its own, for snapshots. @pre as of Entities::addAt; the
/// entity was in a world like this one
void addEntityAt(World& world, Row row, EntityNumber number, const EntityDescription& entity,
                 const std::shared_ptr<const EntityModel>& model, const Pose& pose,
                 const std::vector<Membership>& memberships);

std::shared_ptr<const EntityModel> modelOf(const EntityDescription& entity);
inline Pose poseOf(const EntityDescription& entity) { return {entity.position, orientationFromAngles(entity.angles)}; }

/// Places an entity elsewhere, at rest. @pre it may have the pose, and is not connected to others
void setPose(World& world, Row row, const Pose& pose);

void removeEntity(World& world, Row row);

/// Destroys the robot's controller; an exception is recorded as a failure, and as an event of the next tick.
void destroyController(World& world, RobotInstance& instance);

}  // namespace swarmanoid
