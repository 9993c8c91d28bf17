// What comes from outside, between ticks.
#include "../assembly/assembly.hpp"
#include "../experiment_file/door.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_space/models/limits.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

void Simulation::spawn(const EntityDescription& entity, const std::vector<std::string>& engines) {
  door::check(entity, experiment_);
  std::vector<Claim> claims;
  for (const std::string& engine : engines) {
    claims.push_back({engine, std::nullopt, entity.location});
  }
  const std::vector<Membership> memberships = membershipsOf(entity.id, claims, assembly_->engines);
  if (space_.entities.size() >= limits::kMostEntities) {
    throw ConfigError(entity.location, "found " + std::to_string(space_.entities.size()) +
                                           " entities in the arena already, allowed: no more");
  }
  addEntity(entity, memberships);
  offerRobots();
  space_.index.rebuild(space_.entities);
  pending_events_.push_back({Event::Kind::kSpawned, entity.id, "", entity.type});
}

void Simulation::remove(const std::string& name) {
  const Row row = space_.entities.find(name);
  if (row == kNoRow) {
    throw ConfigError({}, "there is no entity '" + name + "'");
  }
  removeEntity(row);
  offerRobots();
  space_.index.rebuild(space_.entities);
  pending_events_.push_back({Event::Kind::kDeleted, name, "", ""});
}

void Simulation::move(const std::string& name, const Pose& pose) {
  const Row row = space_.entities.find(name);
  if (row == kNoRow) {
    throw ConfigError({}, "there is no entity '" + name + "'");
  }
  if (!pose.position.allFinite() || !pose.orientation.coeffs().allFinite() || pose.orientation.norm() < 1e-6) {
    throw ConfigError({}, "'" + name + "' cannot be moved to a pose that is not finite");
  }
  door::checkPosition("position", pose.position, *space_.entities.model[row], experiment_.arena, {});
  Pose target = pose;
  target.orientation.normalize();
  EntityDescription entity;
  entity.id = name;
  entity.type = space_.entities.model[row]->type;
  refuseBadPlace(entity, *posedModel(space_.entities.model[row], space_.joints[row]), target,
                 assembly_->memberships[row]);
  // what is connected would be torn apart
  space_.structure.isolate(row);
  space_.attachments.isolate(row);
  space_.entities.pose[row] = target;
  space_.entities.twist[row] = Twist{};
  space_.placed[row] = space_.tick;
  for (const Membership& membership : assembly_->memberships[row]) {
    membership.engine->place(space_, row);
  }
  space_.index.rebuild(space_.entities);
  pending_events_.push_back({Event::Kind::kMoved, name, "", ""});
}

void Simulation::reset(std::optional<std::uint64_t> seed, bool rewind) {
  failures_.clear();
  pending_events_.clear();
  unbuild();  // controllers that fail in destroy are failures and events of the run that begins
  logged_overflows_ = 0;
  finish_asked_ = false;
  finished_ = false;
  ++space_.run;
  if (rewind) {
    space_.time_before_reset = Duration::zero();
  } else {
    space_.time_before_reset += space_.time - kEpoch + space_.clocktick;  // one more: no stamp is used twice
  }
  if (seed) {
    space_.seed = *seed;
    experiment_.framework.seed = *seed;
  }
  restoreEngineParameters();
  build();
  for (ObserverInstance& observer : assembly_->observers) {
    observer.is_finished = false;
    callPlugin("reset", observer.part, UserCode::kNoTick, [&] { observer->reset(); });
  }
  start();
}

}  // namespace swarmanoid
