#include "../world/entities.hpp"
#include "carry_out.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
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
                 world.assembly.memberships[row]);
  // the move would tear connections apart
  world.space.structure.isolate(row);
  world.space.attachments.isolate(row);
  world.space.entities.pose[row] = target;
  world.space.entities.twist[row] = Twist{};
  world.space.placed[row] = world.space.tick;
  for (const Membership& membership : world.assembly.memberships[row]) {
    callPlugin("place", partOf(world.assembly.engines, *membership.engine), UserCode::kNoTick,
               [&] { membership.engine->place(world.space, row); });
  }
  if (world.space.entities_without_engine.has(row)) {
    world.space.entities_without_engine.place(world.space.entities, row);
  }
  world.space.index.forget(world.space.entities);
  world.pending_events.push_back({Event::Kind::kMoved, name, "", ""});
  return true;
}

}  // namespace swarmanoid
