// What comes from outside, between ticks.
#include <algorithm>

#include "cast.hpp"
#include "swarmanoid_space/entity_type.hpp"
#include "swarmanoid_space/simulation.hpp"

namespace swarmanoid {
namespace {

[[noreturn]] void refuseUnknown(const EntityDescription& entity, const std::string& what, const std::string& name,
                                const std::vector<std::string>& known) {
  throw ConfigError(entity.location,
                    what + " '" + name + "' does not exist; there are: " + joinNames(known) + didYouMean(name, known));
}

/// Every device that the controller uses must be one that such a robot has.
void checkDevices(const EntityDescription& entity, PluginKind kind, const std::vector<DeviceDescription>& devices) {
  for (const DeviceDescription& device : devices) {
    const auto& robots = Registry::instance().find(kind, device.type, device.implementation)->description.robots;
    if (!robots.empty() && std::find(robots.begin(), robots.end(), entity.type) == robots.end()) {
      throw ConfigError(entity.location, "controller '" + entity.controller + "' uses the " + toString(kind) + " '" +
                                             device.type + "', which a " + entity.type +
                                             " does not have; it is for: " + joinNames(robots));
    }
  }
}

}  // namespace

void Simulation::checkController(const EntityDescription& entity) const {
  if (entity.controller.empty()) {
    return;
  }
  const ControllerGroup* group = cast_->findGroup(entity.controller);
  if (group == nullptr) {
    std::vector<std::string> known;
    for (const auto& candidate : cast_->groups) {
      known.push_back(candidate->description->id);
    }
    refuseUnknown(entity, "controller", entity.controller, known);
  }
  checkDevices(entity, PluginKind::kActuator, group->description->actuators);
  checkDevices(entity, PluginKind::kSensor, group->description->sensors);
}

void Simulation::spawn(const EntityDescription& entity, const std::vector<std::string>& engines) {
  const Registry& registry = Registry::instance();
  if (registry.find(PluginKind::kEntity, entity.type) == nullptr) {
    refuseUnknown(entity, "entity type", entity.type, registry.labels(PluginKind::kEntity));
  }
  std::vector<Seat> seats;
  for (const std::string& id : engines) {
    Engine* engine = cast_->findEngine(id);
    if (engine == nullptr) {
      std::vector<std::string> known;
      for (const auto& candidate : cast_->engines) {
        known.push_back(candidate->id());
      }
      refuseUnknown(entity, "engine", id, known);
    }
    seats.push_back({engine, seats.empty() ? Role::kMove : Role::kMirror});
  }
  checkController(entity);
  addEntity(entity, seats);
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
  const auto i = static_cast<std::size_t>(row);
  if (!pose.position.allFinite() || !pose.orientation.coeffs().allFinite() || pose.orientation.norm() < 1e-6) {
    throw ConfigError({}, "'" + name + "' cannot be moved to a pose that is not finite");
  }
  Pose target = pose;
  target.orientation.normalize();
  EntityDescription entity;
  entity.id = name;
  entity.type = space_.entities.model[i]->type;
  refuseBadPlace(entity, *posedModel(space_.entities.model[i], space_.jointsOf(row)), target, cast_->seats[i]);
  // what is connected would be torn apart
  space_.structure.isolate(row);
  space_.attachments.isolate(row);
  space_.entities.pose[i] = target;
  space_.entities.twist[i] = Twist{};
  for (const Seat& seat : cast_->seats[i]) {
    seat.engine->place(space_, row);
  }
  space_.index.rebuild(space_.entities);
  pending_events_.push_back({Event::Kind::kMoved, name, "", ""});
}

void Simulation::reset(std::optional<std::uint64_t> seed, bool rewind) {
  failures_.clear();
  unbuild();  // controllers that fail in destroy are failures of the run that begins
  pending_events_.clear();
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
  for (const auto& visualisation : cast_->visualisations) {
    visualisation->reset();
  }
  start();
}

}  // namespace swarmanoid
