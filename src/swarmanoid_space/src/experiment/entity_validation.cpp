#include "swarmanoid_space/experiment/entity_validation.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/readable_number.hpp"
#include "swarmanoid_space/experiment/entity_parameters.hpp"
#include "swarmanoid_space/models/entity_type.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::validation {
namespace {

[[noreturn]] void refuse(const SourceLocation& location, const std::string& what, const std::string& found,
                         const std::string& allowed) {
  throw ConfigError(location, what + ": found '" + found + "', allowed: " + allowed);
}

std::string textOf(const Eigen::Vector3d& v) {
  return readableNumber(v.x()) + ", " + readableNumber(v.y()) + ", " + readableNumber(v.z());
}

SourceLocation locationOf(const EntityDescription& entity, const char* value) {
  const Configuration* found = entity.parameters.find(value);
  return found == nullptr || found->location().file.empty() ? entity.location : found->location();
}

const Registry::Entry& requireType(const EntityDescription& entity) {
  const Registry::Entry* entry = Registry::instance().find(PluginKind::kEntity, entity.type);
  if (entry == nullptr) {
    const std::vector<std::string> known = Registry::instance().labels(PluginKind::kEntity);
    refuse(entity.location, "type", entity.type, joinNames(known) + didYouMean(entity.type, known));
  }
  return *entry;
}

/// Checks that each value belongs to the type, is given at most once, and is within its bounds.
void checkValues(const EntityDescription& entity, const PluginDescription& type) {
  const std::vector<Parameter> table = experiment::entityParameters(type, false);
  std::vector<std::string> names;
  for (const Parameter& parameter : table) {
    names.push_back(parameter.name);
  }
  std::set<std::string> given;
  for (const Configuration& value : entity.parameters.children()) {
    const SourceLocation& location = value.location().file.empty() ? entity.location : value.location();
    const auto known = std::find(names.begin(), names.end(), value.name());
    if (known == names.end()) {
      refuse(location, "parameter of a " + entity.type, value.name(),
             joinNames(names) + didYouMean(value.name(), names));
    }
    if (!given.insert(value.name()).second) {
      throw ConfigError(location, "found a second '" + value.name() + "' of a " + entity.type + ", allowed: one");
    }
    checkValue(table[static_cast<std::size_t>(known - names.begin())], value.text(), location);
  }
  for (const Parameter& parameter : type.parameters) {
    if (!parameter.value && given.count(parameter.name) == 0) {
      throw ConfigError(entity.location, "a " + entity.type + " needs the parameter '" + parameter.name + "'");
    }
  }
}

void checkDevices(const SourceLocation& location, const EntityDescription& entity, const EntityModel& model,
                  PluginKind kind, const std::vector<DeviceDescription>& devices) {
  for (const DeviceDescription& device : devices) {
    const Registry::Entry* entry = Registry::instance().find(kind, device.type, device.implementation);
    if (entry == nullptr) {
      continue;  // its library is not loaded (`swarmanoid validate --no-libraries`)
    }
    const auto& robots = entry->description.robots;
    const bool is_carried = robots.empty() || contains(robots, entity.type) || contains(model.devices, device.type);
    if (!is_carried) {
      throw ConfigError(location, "controller '" + entity.controller + "' uses the " + toString(kind) + " '" +
                                      device.type + "', which a " + entity.type +
                                      " does not have; it is for: " + joinNames(robots));
    }
    for (const Mechanism& mechanism : entry->description.mechanisms) {
      if (const std::string part = model.missingPart(mechanism); !part.empty()) {
        throw ConfigError(location, "controller '" + entity.controller + "' uses the " + toString(kind) + " '" +
                                        device.type + "', and a " + entity.type + " has no " + part +
                                        ", allowed: robots that have it");
      }
    }
  }
}

void checkController(const EntityDescription& entity, const EntityType& type, const EntityModel& model,
                     const Experiment& experiment) {
  if (entity.controller.empty()) {
    return;
  }
  const SourceLocation& location =
      entity.controller_location.file.empty() ? entity.location : entity.controller_location;
  if (!type.isRobot()) {
    throw ConfigError(location, "a " + entity.type + " has no controller, found '" + entity.controller + "'");
  }
  const auto& controllers = experiment.controllers;
  const auto found = std::find_if(controllers.begin(), controllers.end(),
                                  [&](const auto& candidate) { return candidate.id == entity.controller; });
  if (found == controllers.end()) {
    std::vector<std::string> known;
    for (const ControllerDescription& candidate : controllers) {
      known.push_back(candidate.id);
    }
    throw ConfigError(location,
                      "controller of a " + entity.type + ": " + unknownName("the id", entity.controller, known));
  }
  checkDevices(location, entity, model, PluginKind::kActuator, found->actuators);
  checkDevices(location, entity, model, PluginKind::kSensor, found->sensors);
}

/// Checks the properties that a type declares: names as for entities, each once, and an initial value within the range.
void checkProperties(const EntityDescription& entity, const EntityModel& model) {
  std::set<std::string> names{"color"};  // reserved for the colour of the surface
  for (const EntityModel::Property& property : model.properties) {
    if (!isName(property.name) || !names.insert(property.name).second) {
      refuse(entity.location, "property of a " + entity.type, property.name,
             std::string(kNamesAllowed) + "; each once, and not color");
    }
    if (!std::isfinite(property.initial) || !property.range.contains(property.initial)) {
      refuse(entity.location, property.name + " of a " + entity.type, numberText(property.initial),
             "a number, " + property.range.toString());
    }
  }
}

/// Creates the model. Errors about values from code get the location of the entity.
std::shared_ptr<const EntityModel> makeModel(const EntityType& type, const EntityDescription& entity) {
  try {
    return type.makeModel(entity.parameters);
  } catch (const ConfigError& error) {
    if (error.location().file.empty()) {
      throw ConfigError(entity.location, error.what());
    }
    throw;
  }
}

}  // namespace

bool isName(const std::string& text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  const auto is_good = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !text.empty() && is_letter(text[0]) && std::all_of(text.begin(), text.end(), is_good);
}

void check(const EntityDescription& entity, const Experiment& experiment) {
  if (!isName(entity.id)) {
    refuse(entity.location, "name", entity.id, kNamesAllowed);
  }
  const Registry::Entry& entry = requireType(entity);
  checkValues(entity, entry.description);
  if (!entity.angles.allFinite()) {
    refuse(locationOf(entity, "orientation"), "orientation", textOf(entity.angles), "three finite numbers");
  }
  const auto type = makePlugin<EntityType>(entry);
  const auto model = makeModel(*type, entity);
  checkProperties(entity, *model);
  checkController(entity, *type, *model, experiment);
  if (!entity.distribution) {
    checkPosition("position", entity.position, *model, experiment.arena, locationOf(entity, "position"));
    return;
  }
  const Distribution& places = *entity.distribution;
  if (!places.around.empty()) {
    return;  // the area is relative to an entity that is not placed yet
  }
  const bool is_box = places.area == Distribution::Area::kBox;
  const Eigen::AlignedBox3d bounds = places.bounds();
  checkPosition(is_box ? "minimum" : "least coordinates", bounds.min(), *model, experiment.arena, places.location);
  checkPosition(is_box ? "maximum" : "greatest coordinates", bounds.max(), *model, experiment.arena, places.location);
}

void checkPosition(const std::string& what, const Eigen::Vector3d& position, const EntityModel& model,
                   const ArenaDescription& arena, const SourceLocation& location) {
  constexpr double kTolerance = 1e-3;  // m: as for the event left_arena, except at the ground
  const double lowest = arena.terrain ? std::min(0.0, arena.terrain->bounds().min().z()) : 0.0;
  const Eigen::Vector3d corner(arena.corner.x(), arena.corner.y(), lowest);
  Eigen::Vector3d least = corner.array() - kTolerance;
  Eigen::Vector3d most = arena.farCorner().array() + kTolerance;
  if (!model.is_movable) {
    least.fill(limits::kCoordinate.minimum);
    most.fill(limits::kCoordinate.maximum);
  }
  const bool is_inside = (position.array() >= least.array()).all() && (position.array() <= most.array()).all();
  if (is_inside) {
    return;  // NaN is not inside
  }
  if (!model.is_movable) {
    refuse(location, what, textOf(position), "3 numbers, each " + limits::kCoordinate.toString());
  }
  refuse(location, what, textOf(position), "in the arena, from " + textOf(corner) + " to " + textOf(arena.farCorner()));
}

}  // namespace swarmanoid::validation
