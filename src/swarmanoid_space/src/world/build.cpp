// Builds the state before tick 0 from an experiment's description.
#include "build.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "configure.hpp"
#include "distribute.hpp"
#include "entities.hpp"
#include "offers.hpp"
#include "scripts.hpp"
#include "swarmanoid_interface/process/user_code.hpp"
#include "swarmanoid_interface/step_controller.hpp"
#include "swarmanoid_space/experiment/entity_validation.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

/// Creates and configures a device, and adds it to the group.
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

/// @throws ConfigError for more than limits::kMostEntities entities
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

/// @throws ConfigError if simulated time would overflow
void refuseEndlessRun(const FrameworkDescription& framework) {
  using Years = std::chrono::duration<double, std::ratio<31536000>>;
  const double years = static_cast<double>(framework.max_clock) * Years(framework.clocktick).count();
  if (years > Years(limits::kLongestRun).count()) {
    throw ConfigError(framework.location, "maxclock: found " + std::to_string(framework.max_clock) + " ticks of " +
                                              numberText(1e3 * toSeconds(framework.clocktick)) +
                                              " ms, allowed: 100 years of simulated time");
  }
}

/// Gives the group its controller: one for all robots, or a function that creates one for each.
void giveController(World& world, const ControllerDescription& description, ControllerGroup& group) {
  const SuppliedParts& supplied = world.supplied;
  const auto together = supplied.group_controllers.find(description.id);
  const auto single = supplied.controllers.find(description.id);
  if (together != supplied.group_controllers.end()) {
    group.together = together->second;
  } else if (single != supplied.controllers.end()) {
    group.make = single->second;
  } else if (!description.script.empty()) {
    group.together = controllerInScript(world, description);
  } else {
    const auto* entry = Registry::instance().find(PluginKind::kController, description.label);
    group.make = [entry] { return makePlugin<Controller>(*entry); };
  }
  if (group.together != nullptr) {
    group.part = "controller '" + description.id + "' of all its robots";
    initTogether(group);
  }
}

}  // namespace

void buildControllerGroups(World& world) {
  for (const ControllerDescription& description : world.experiment.controllers) {
    auto group = std::make_unique<ControllerGroup>();
    group->description = &description;
    for (const DeviceDescription& device : description.sensors) {
      addDevice(PluginKind::kSensor, device, description.id, group->sensors, group->devices);
    }
    for (const DeviceDescription& device : description.actuators) {
      addDevice(PluginKind::kActuator, device, description.id, group->actuators, group->devices);
    }
    group->part = controllerPart(description.id, description.label);
    giveController(world, description, *group);
    world.assembly.groups.push_back(std::move(group));
  }
}

namespace {

void buildBoundary(World& world) {
  if (!world.experiment.arena.bounded) {
    return;
  }
  constexpr double kThickness = 0.1;
  const Eigen::Vector3d& size = world.experiment.arena.size;
  const Eigen::Vector3d& least = world.experiment.arena.corner;
  const Eigen::Vector3d most = world.experiment.arena.farCorner();
  std::vector<Membership> everywhere;
  for (const auto& engine : world.assembly.engines) {
    everywhere.push_back({engine.get(), Role::kMove});
  }
  const auto addWall = [&](const std::string& side, const Eigen::Vector3d& centre, const Eigen::Vector3d& extent) {
    EntityDescription wall;
    wall.type = "block";
    wall.id = "boundary_" + side;
    wall.position = centre;
    wall.location = world.experiment.arena.location;
    wall.parameters = Configuration("block", "", wall.location);
    wall.parameters.set("size", numberText(extent.x()) + "," + numberText(extent.y()) + "," + numberText(extent.z()));
    addEntity(world, wall, everywhere);
  };
  const double half = 0.5 * kThickness;
  const Eigen::Vector3d middle = least + 0.5 * size;
  const Eigen::Vector3d along_x(size.x() + 2.0 * kThickness, kThickness, size.z());
  const Eigen::Vector3d along_y(kThickness, size.y(), size.z());
  addWall("south", {middle.x(), least.y() - half, middle.z()}, along_x);
  addWall("north", {middle.x(), most.y() + half, middle.z()}, along_x);
  addWall("west", {least.x() - half, middle.y(), middle.z()}, along_y);
  addWall("east", {most.x() + half, middle.y(), middle.z()}, along_y);
}

void buildEntities(World& world) {
  std::unordered_map<std::string, std::vector<Claim>> claims;  // by entity
  for (const MappingDescription& mapping : world.experiment.mappings) {
    for (const MappingDescription::Member& member : mapping.members) {
      claims[member.entity].push_back({mapping.engine, member.role, member.location});
    }
  }
  for (const EntityDescription& entity : world.experiment.arena.entities) {
    validation::check(entity, world.experiment);
    const std::vector<Membership> memberships = membershipsOf(entity.id, claims[entity.id], world.assembly.engines);
    if (entity.distribution) {
      distribute(world, entity, memberships);
    } else {
      addEntity(world, entity, memberships);
    }
  }
}

/// Returns the clean floor.
Floor floorOf(const Experiment& experiment) {
  Floor floor = experiment.arena.floor;
  if (const auto& paint = experiment.arena.paint) {
    floor.paint =
        PaintLayer(experiment.arena.size.head<2>(), paint->cell,
                   paint->half_life / toSeconds(experiment.framework.clocktick), experiment.arena.corner.head<2>());
  }
  return floor;
}

}  // namespace

void initTogether(const ControllerGroup& group) {
  const UserCode code{"init", group.part, ""};
  const UserCall call(code);
  try {
    group.together->init(group.description->parameters);
  } catch (const ConfigError&) {
    throw;
  } catch (...) {
    throw ConfigError(group.description->location, group.part + " does not start: " + describeException());
  }
}

void buildEngines(World& world) {
  refuseEndlessRun(world.experiment.framework);
  for (const EngineDescription& description : world.experiment.engines) {
    const std::string part = "engine '" + description.id + "' (" + description.label + ")";
    const auto supplied = world.supplied.engines.find(description.id);
    if (supplied != world.supplied.engines.end()) {
      world.assembly.engines.push_back({supplied->second, part});
    } else {
      const auto* entry = Registry::instance().find(PluginKind::kEngine, description.label);
      world.assembly.engines.push_back({makePlugin<Engine>(*entry), part});
      configure(world.assembly.engines.back(), description.location, description.id, description.parameters);
    }
    const std::string problem =
        world.assembly.engines.back()->unsupportedClocktickReason(world.experiment.framework.clocktick);
    if (!problem.empty()) {
      throw ConfigError(description.location, description.label + " '" + description.id + "': " + problem);
    }
    world.assembly.engines.back()->prepare({world.experiment.arena.terrain, &world.assembly.workers});
    world.space.engines.push_back(world.assembly.engines.back().get());
    world.engine_parameters.emplace_back();
  }
}

void build(World& world) {
  world.space.clocktick = world.experiment.framework.clocktick;
  world.space.tick = 0;
  world.space.time = kEpoch;
  world.space.corner = world.experiment.arena.corner;
  world.space.size = world.experiment.arena.size;
  world.space.floor = floorOf(world.experiment);
  world.space.terrain = world.experiment.arena.terrain;
  constexpr std::size_t kUsualEvents = 64;  // per tick; more are possible, but allocate
  world.space.events.reserve(kUsualEvents);
  world.space.index.configure(world.space.size, world.experiment.arena.optimization,
                              entityCount(world.experiment.arena), world.space.corner);
  world.space.entities_without_engine.configure(world.space.size, world.space.corner);
  buildControllerGroups(world);
  buildBoundary(world);
  buildEntities(world);
  world.space.index.forget(world.space.entities);  // rules use the index when the run begins
  buildTriggers(world);
  offerRobots(world);
}

void buildObservers(World& world) {
  for (const VisualisationDescription& description : world.experiment.visualisations) {
    const auto* entry = Registry::instance().find(PluginKind::kObserver, description.label);
    const ObserverInstance observer{
        {makePlugin<Observer>(*entry), "visualisation '" + description.id + "' (" + description.label + ")"}};
    configure(observer, description.location, description.id, description.parameters, world.context);
    world.assembly.observers.push_back(observer);
  }
}

void unbuild(World& world) {
  for (RobotInstance& instance : world.assembly.robots) {
    destroyController(world, instance);
  }
  world.assembly.robots.clear();
  for (const auto& engine : world.assembly.engines) {
    engine->clear();
  }
  world.assembly.groups.clear();
  world.assembly.triggers.clear();
  world.space.attachments.clear();
  world.space.entities.clear();
  world.space.laser_spots.clear();
  world.space.events.clear();
  world.space.interventions.clear();
  world.space.overflows.clear();
  world.space.readings.clear();
  world.space.commands.clear();
  world.space.actuation.clear();
  world.space.entities_without_engine.clear();
  world.space.powered.clear();
}

}  // namespace swarmanoid
