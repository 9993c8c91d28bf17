#include "swarmanoid_space/interventions/spawned_entity.hpp"

#include "swarmanoid_interface/orientation.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {
namespace {

/// Returns the given values unchanged, and defaults for the others.
Configuration valuesOf(const AskedEntity& asked, const std::vector<Parameter>& table, const SourceLocation& location) {
  Configuration result(asked.type, "", location);
  for (const auto& [name, value] : asked.values) {
    result.set(name, value);
  }
  for (const Parameter& parameter : table) {
    if (result.has(parameter.name)) {
      continue;
    }
    if (parameter.value) {
      result.set(parameter.name, *parameter.value);
    } else if (parameter.type == Parameter::Type::kColor) {
      result.set(parameter.name, toString(asked.color.value_or(colors::kBlack)));
    }
  }
  return result;
}

}  // namespace

EntityDescription describeEntity(const AskedEntity& asked) {
  EntityDescription entity;
  entity.location = {"spawned '" + asked.name + "'", 0};
  entity.type = asked.type;
  entity.id = asked.name;
  entity.controller = asked.controller;
  const Registry::Entry* entry = Registry::instance().find(PluginKind::kEntity, asked.type);
  if (entry != nullptr) {  // otherwise the space refuses the type
    entity.type = entry->description.label;
    entity.parameters = valuesOf(asked, entry->description.parameters, entity.location);
  }
  entity.position = asked.pose.position;
  entity.angles = anglesFromOrientation(asked.pose.orientation.normalized());
  entity.color = asked.color ? *asked.color : entity.parameters.color("color", colors::kBlack);
  return entity;
}

}  // namespace swarmanoid
