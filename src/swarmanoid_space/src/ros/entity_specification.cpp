#include "entity_specification.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "../experiment/parameter_table.hpp"
#include "swarmanoid_interface/ros/device_messages.hpp"
#include "swarmanoid_space/entity_type.hpp"
#include "swarmanoid_space/ros/world_state.hpp"

namespace swarmanoid {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& found, const std::vector<std::string>& allowed) {
  throw std::runtime_error(what + ": found '" + found + "', allowed: " + joinNames(allowed) +
                           didYouMean(found, allowed));
}

/// Names end up in topics and frames.
void checkEntityName(const std::string& name) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto is_good = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  if (name.empty() || !is_letter(name[0]) || !std::all_of(name.begin(), name.end(), is_good)) {
    throw std::runtime_error("name: found '" + name + "', allowed: letters, digits and _, a letter first");
  }
}

Configuration readParameters(const swarmanoid_msgs::EntitySpecification& specification,
                             const std::vector<Parameter>& table) {
  std::vector<std::string> names;
  for (const Parameter& parameter : table) {
    names.push_back(parameter.name);
  }
  for (const auto& given : specification.parameters) {
    if (std::find(names.begin(), names.end(), given.name) == names.end()) {
      refuse("parameter of a " + specification.type, given.name, names);
    }
  }
  Configuration result(specification.type, "", {});
  for (const Parameter& parameter : table) {
    const auto given = std::find_if(specification.parameters.begin(), specification.parameters.end(),
                                    [&](const auto& candidate) { return candidate.name == parameter.name; });
    if (given != specification.parameters.end()) {
      experiment::checkValue(parameter, given->value, {});
      result.set(parameter.name, given->value);
    } else if (parameter.value) {
      result.set(parameter.name, *parameter.value);
    } else if (parameter.type == Parameter::Type::kColor) {
      result.set(parameter.name, toString(fromMessage(specification.color)));
    } else {
      throw std::runtime_error("a " + specification.type + " needs the parameter '" + parameter.name + "'");
    }
  }
  return result;
}

/// Every device that the controller uses must be one that such a robot has.
void checkDevices(const std::string& type, const ControllerDescription& controller, PluginKind kind,
                  const std::vector<DeviceDescription>& devices) {
  for (const DeviceDescription& device : devices) {
    const auto& robots = Registry::instance().find(kind, device.type, device.implementation)->description.robots;
    if (!robots.empty() && std::find(robots.begin(), robots.end(), type) == robots.end()) {
      throw std::runtime_error("controller '" + controller.id + "' uses the " + toString(kind) + " '" + device.type +
                               "', which a " + type + " does not have");
    }
  }
}

void checkController(const swarmanoid_msgs::EntitySpecification& specification, const EntityType& type,
                     const Experiment& experiment) {
  if (specification.controller.empty()) {
    return;
  }
  if (!type.isRobot()) {
    throw std::runtime_error("a " + specification.type + " has no controller");
  }
  std::vector<std::string> known;
  for (const ControllerDescription& controller : experiment.controllers) {
    known.push_back(controller.id);
    if (controller.id == specification.controller) {
      checkDevices(specification.type, controller, PluginKind::kSensor, controller.sensors);
      checkDevices(specification.type, controller, PluginKind::kActuator, controller.actuators);
      return;
    }
  }
  refuse("controller", specification.controller, known);
}

}  // namespace

EntityDescription toDescription(const swarmanoid_msgs::EntitySpecification& specification,
                                const Experiment& experiment) {
  checkEntityName(specification.name);
  const Registry::Entry* entry = Registry::instance().find(PluginKind::kEntity, specification.type);
  if (entry == nullptr) {
    refuse("type", specification.type, Registry::instance().labels(PluginKind::kEntity));
  }
  checkController(specification, *makePlugin<EntityType>(*entry), experiment);

  EntityDescription entity;
  entity.type = entry->description.label;
  entity.id = specification.name;
  entity.controller = specification.controller;
  entity.parameters = readParameters(specification, entry->description.parameters);
  const Pose pose = fromMessage(specification.pose.header, specification.pose.pose);
  entity.position = pose.position;
  entity.angles = anglesFromOrientation(pose.orientation);
  entity.color = specification.color.a > 0.0F ? fromMessage(specification.color)
                                              : entity.parameters.color("color", colors::kBlack);
  entity.location = {"spawned '" + specification.name + "'", 0};
  return entity;
}

}  // namespace swarmanoid
