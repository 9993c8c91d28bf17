// From an experiment's description to its state before tick 0.
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "../assembly/assembly.hpp"
#include "../experiment_file/door.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_interface/step_controller.hpp"
#include "swarmanoid_space/lockstep/lockstep.hpp"
#include "swarmanoid_space/models/entity_type.hpp"
#include "swarmanoid_space/models/limits.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {
namespace {

/// @throws ConfigError for whatever the plugin throws
template <class Plugin, class... Arguments>
void configure(const Named<Plugin>& plugin, const SourceLocation& location, const Arguments&... arguments) {
  const UserCode code{"configure", plugin.part, "", UserCode::kNoTick, false};
  const UserCall call(code);
  try {
    plugin->configure(arguments...);
  } catch (const ConfigError&) {
    throw;
  } catch (...) {
    throw ConfigError(location, plugin.part + " cannot be configured: " + describeException());
  }
}

/// Adds a device to the group, configured.
template <class Plugin>
void addDevice(PluginKind kind, const DeviceDescription& description, const std::string& controller,
               std::vector<Named<Plugin>>& plugins, std::vector<DeviceUse>& uses) {
  const Registry::Entry& entry = *Registry::instance().find(kind, description.type, description.implementation);
  plugins.push_back({makePlugin<Plugin>(entry),
                     std::string(toString(kind)) + " '" + description.type + "' of controller '" + controller + "'"});
  uses.push_back({description.type, entry.description.mechanisms,
                  kind == PluginKind::kActuator ? DeviceKind::kActuator : DeviceKind::kSensor});
  configure(plugins.back(), description.location, description.parameters);
  plugins.back()->takeErrors(description.errors);
}

/// @throws ConfigError if there are more than memory can be expected to hold
std::size_t entityCount(const ArenaDescription& arena) {
  std::size_t count = 0;
  for (const EntityDescription& entity : arena.entities) {
    count += entity.distribution ? entity.distribution->quantity : 1;
  }
  if (count > limits::kMostEntities) {
    throw ConfigError(arena.location, "found " + std::to_string(count) + " entities, allowed: at most " +
                                          std::to_string(limits::kMostEntities));
  }
  return count;
}

/// @throws ConfigError if simulated time would not fit its numbers
void refuseEndlessRun(const FrameworkDescription& framework) {
  using Years = std::chrono::duration<double, std::ratio<31536000>>;
  const double years = static_cast<double>(framework.max_clock) * Years(framework.clocktick).count();
  if (years > Years(limits::kLongestRun).count()) {
    throw ConfigError(framework.location, "maxclock: found " + std::to_string(framework.max_clock) + " ticks of " +
                                              numberText(1e3 * toSeconds(framework.clocktick)) +
                                              " ms, allowed: 100 years of simulated time");
  }
}

}  // namespace

Simulation::Simulation(Experiment experiment, RunContext context, SuppliedParts supplied)
    : experiment_(std::move(experiment)), context_(std::move(context)), supplied_(std::move(supplied)) {
  context_.experiment = &experiment_;
  assembly_ = std::make_unique<Assembly>(experiment_.framework.threads, space_.entities.columns);
  lockstep_ = std::make_unique<Lockstep>();
  space_.seed = experiment_.framework.seed;
  refuseEndlessRun(experiment_.framework);
  buildEngines();
  build();
  for (const VisualisationDescription& description : experiment_.visualisations) {
    const auto* entry = Registry::instance().find(PluginKind::kObserver, description.label);
    const ObserverInstance observer{
        {makePlugin<Observer>(*entry), "visualisation '" + description.id + "' (" + description.label + ")"}};
    configure(observer, description.location, description.id, description.parameters, context_);
    assembly_->observers.push_back(observer);
  }
}

Simulation::~Simulation() {
  try {
    finish();
  } catch (...) {
    // a recorder that cannot complete its file must not end the program; finish() called by hand reports it
  }
  try {
    unbuild();
  } catch (...) {
    // what a plugin throws when it is let go does no harm any more
  }
}

void Simulation::buildEngines() {
  for (const EngineDescription& description : experiment_.engines) {
    const std::string part = "engine '" + description.id + "' (" + description.label + ")";
    const auto supplied = supplied_.engines.find(description.id);
    if (supplied != supplied_.engines.end()) {
      assembly_->engines.push_back({supplied->second, part});
    } else {
      const auto* entry = Registry::instance().find(PluginKind::kEngine, description.label);
      assembly_->engines.push_back({makePlugin<Engine>(*entry), part});
      configure(assembly_->engines.back(), description.location, description.id, description.parameters);
    }
    const std::string problem = assembly_->engines.back()->unsupportedClocktickReason(experiment_.framework.clocktick);
    if (!problem.empty()) {
      throw ConfigError(description.location, description.label + " '" + description.id + "': " + problem);
    }
    assembly_->engines.back()->takeTerrain(experiment_.arena.terrain);
    space_.engines.push_back(assembly_->engines.back().get());
    engine_parameters_.push_back(description.parameters);
  }
}

void Simulation::build() {
  space_.clocktick = experiment_.framework.clocktick;
  space_.tick = 0;
  space_.time = kEpoch;
  space_.size = experiment_.arena.size;
  space_.floor = experiment_.arena.floor;
  space_.terrain = experiment_.arena.terrain;
  constexpr std::size_t kUsualEvents = 64;  // in one tick; more are possible, but allocate
  space_.events.reserve(kUsualEvents);
  space_.index.configure(space_.size, experiment_.arena.optimization, entityCount(experiment_.arena));
  buildControllerGroups();
  buildBoundary();
  buildEntities();
  buildTriggers();
  offerRobots();
}

void Simulation::buildControllerGroups() {
  for (const ControllerDescription& description : experiment_.controllers) {
    auto group = std::make_unique<ControllerGroup>();
    group->description = &description;
    for (const DeviceDescription& device : description.sensors) {
      addDevice(PluginKind::kSensor, device, description.id, group->sensors, group->devices);
    }
    for (const DeviceDescription& device : description.actuators) {
      addDevice(PluginKind::kActuator, device, description.id, group->actuators, group->devices);
    }
    group->part = controllerPart(description.id, description.label);
    const auto supplied = supplied_.controllers.find(description.id);
    if (supplied != supplied_.controllers.end()) {
      group->make = supplied->second;
    } else {
      const auto* entry = Registry::instance().find(PluginKind::kController, description.label);
      group->make = [entry] { return makePlugin<Controller>(*entry); };
    }
    assembly_->groups.push_back(std::move(group));
  }
}

void Simulation::buildBoundary() {
  if (!experiment_.arena.bounded) {
    return;
  }
  constexpr double kThickness = 0.1;
  const Eigen::Vector3d& size = experiment_.arena.size;
  std::vector<Membership> everywhere;
  for (const auto& engine : assembly_->engines) {
    everywhere.push_back({engine.get(), Role::kMove});
  }
  const auto addWall = [&](const std::string& side, const Eigen::Vector3d& centre, const Eigen::Vector3d& extent) {
    EntityDescription wall;
    wall.type = "block";
    wall.id = "boundary_" + side;
    wall.position = centre;
    wall.location = experiment_.arena.location;
    wall.parameters = Configuration("block", "", wall.location);
    wall.parameters.set("size", numberText(extent.x()) + "," + numberText(extent.y()) + "," + numberText(extent.z()));
    addEntity(wall, everywhere);
  };
  const double half = 0.5 * kThickness;
  const Eigen::Vector3d middle = 0.5 * size;
  const Eigen::Vector3d along_x(size.x() + 2.0 * kThickness, kThickness, size.z());
  const Eigen::Vector3d along_y(kThickness, size.y(), size.z());
  addWall("south", {middle.x(), -half, middle.z()}, along_x);
  addWall("north", {middle.x(), size.y() + half, middle.z()}, along_x);
  addWall("west", {-half, middle.y(), middle.z()}, along_y);
  addWall("east", {size.x() + half, middle.y(), middle.z()}, along_y);
}

void Simulation::buildEntities() {
  std::unordered_map<std::string, std::vector<Claim>> claims;  // by entity
  for (const MappingDescription& mapping : experiment_.mappings) {
    for (const MappingDescription::Member& member : mapping.members) {
      claims[member.entity].push_back({mapping.engine, member.role, member.location});
    }
  }
  for (const EntityDescription& entity : experiment_.arena.entities) {
    door::check(entity, experiment_);
    const std::vector<Membership> memberships = membershipsOf(entity.id, claims[entity.id], assembly_->engines);
    if (entity.distribution) {
      distribute(entity, memberships);
    } else {
      addEntity(entity, memberships);
    }
  }
}

void Simulation::distribute(const EntityDescription& group, const std::vector<Membership>& memberships) {
  const Distribution& distribution = *group.distribution;
  const auto type = makePlugin<EntityType>(*Registry::instance().find(PluginKind::kEntity, group.type));
  const auto model = type->makeModel(group.parameters);
  RandomStream random(space_.seed, "distribute", group.id);
  const Eigen::Vector3d extent = distribution.maximum - distribution.minimum;
  const auto quantity = static_cast<double>(distribution.quantity);
  const double side_by_side = std::ceil(std::sqrt(quantity * extent.x() / std::max(extent.y(), 1e-9)));
  const auto columns = static_cast<std::size_t>(std::clamp(side_by_side, 1.0, quantity));
  const std::size_t rows = (distribution.quantity + columns - 1) / columns;

  EntityDescription entity = group;
  entity.distribution.reset();
  for (std::size_t k = 0; k < distribution.quantity; ++k) {
    entity.id = group.id + "_" + std::to_string(k + 1);
    random.startTick(k);
    int trials = 0;
    for (bool placed = false; !placed; ++trials) {
      if (trials == distribution.max_trials) {
        throw ConfigError(group.location, "no free place found for '" + entity.id + "' of " +
                                              std::to_string(distribution.quantity) + " in " + std::to_string(trials) +
                                              " trials; allow more area or fewer entities");
      }
      const bool is_grid = distribution.layout == Distribution::Layout::kGrid;
      const double u =
          is_grid ? (static_cast<double>(k % columns) + 0.5) / static_cast<double>(columns) : random.uniform();
      const double v =
          is_grid ? (static_cast<double>(k / columns) + 0.5) / static_cast<double>(rows) : random.uniform();
      const double w = is_grid ? 0.0 : random.uniform();
      entity.position = distribution.minimum + extent.cwiseProduct(Eigen::Vector3d(u, v, w));
      if (distribution.random_heading) {
        entity.angles.z() = random.uniform(-M_PI, M_PI);
      }
      const Pose pose{entity.position, orientationFromAngles(entity.angles)};
      placed = is_grid || std::none_of(memberships.begin(), memberships.end(), [&](const Membership& membership) {
                 return membership.engine->overlap(*model, pose, kNoRow) != kNoRow;
               });
    }
    addEntity(entity, memberships);
  }
}

}  // namespace swarmanoid
