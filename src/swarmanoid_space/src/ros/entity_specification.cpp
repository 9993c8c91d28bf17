#include "entity_specification.hpp"

#include "swarmanoid_hosts/ros/device_messages.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/ros/world_state.hpp"

namespace swarmanoid {
namespace {

/// What was given, as it was given, and defaults for the rest.
Configuration valuesOf(const swarmanoid_msgs::EntitySpecification& specification, const std::vector<Parameter>& table,
                       const SourceLocation& location) {
  Configuration result(specification.type, "", location);
  for (const auto& given : specification.parameters) {
    result.set(given.name, given.value);
  }
  for (const Parameter& parameter : table) {
    if (result.has(parameter.name)) {
      continue;
    }
    if (parameter.value) {
      result.set(parameter.name, *parameter.value);
    } else if (parameter.type == Parameter::Type::kColor) {
      result.set(parameter.name, toString(fromMessage(specification.color)));
    }
  }
  return result;
}

}  // namespace

EntityDescription toDescription(const swarmanoid_msgs::EntitySpecification& specification) {
  EntityDescription entity;
  entity.location = {"spawned '" + specification.name + "'", 0};
  entity.type = specification.type;
  entity.id = specification.name;
  entity.controller = specification.controller;
  const Registry::Entry* entry = Registry::instance().find(PluginKind::kEntity, specification.type);
  if (entry != nullptr) {  // else the space refuses it
    entity.type = entry->description.label;
    entity.parameters = valuesOf(specification, entry->description.parameters, entity.location);
  }
  const Pose pose = fromMessage(specification.pose.header, specification.pose.pose);
  entity.position = pose.position;
  entity.angles = anglesFromOrientation(pose.orientation);
  entity.color = specification.color.a > 0.0F ? fromMessage(specification.color)
                                              : entity.parameters.color("color", colors::kBlack);
  return entity;
}

}  // namespace swarmanoid
