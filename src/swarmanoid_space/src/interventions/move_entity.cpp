#include "../world/entities.hpp"
#include "carry_out.hpp"
#include "swarmanoid_space/experiment/entity_validation.hpp"

namespace swarmanoid {

bool carryOut(World& world, const MoveEntity& intervention) {
  const std::string& name = intervention.entity;
  const Pose& pose = intervention.pose;
  const Row row = world.space.entities.require(name);
  if (!pose.position.allFinite() || !pose.orientation.coeffs().allFinite() || pose.orientation.norm() < 1e-6) {
    throw ConfigError({}, "'" + name + "' cannot be moved to a pose that is not finite");
  }
  validation::checkPosition("position", pose.position, *world.space.entities.model[row], world.experiment.arena, {});
  Pose target = pose;
  target.orientation.normalize();
  EntityDescription entity;
  entity.id = name;
  entity.type = world.space.entities.model[row]->type;
  refuseBadPlace(world, entity, *posedModel(world.space.entities.model[row], world.space.joints[row]), target,
                 world.assembly.memberships[row], Span<const Row>(&row, 1));
  // the move would tear connections apart
  world.space.structure.isolate(row);
  world.space.attachments.isolate(row);
  setPose(world, row, target);
  world.space.index.forget(world.space.entities);
  world.pending_events.push_back({Event::Kind::kMoved, name, "", ""});
  return true;
}

}  // namespace swarmanoid
