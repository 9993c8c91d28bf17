// Changes properties of arena objects: the light of lamps, the content of stations, the colour of preys.
#include "carry_out.hpp"

namespace swarmanoid {
namespace {

/// Returns "light 'lamp'".
std::string describeEntity(const Entities& entities, Row row) {
  return entities.model[row]->type + " '" + entities.name[row] + "'";
}

[[noreturn]] void refuseProperty(const Entities& entities, Row row, const std::string& property) {
  const EntityModel& model = *entities.model[row];
  std::vector<std::string> names;
  if (model.hasColor()) {
    names.emplace_back(kColorProperty);
  }
  for (const EntityModel::Property& each : model.properties) {
    names.push_back(each.name);
  }
  throw ConfigError({}, describeEntity(entities, row) + ": " + unknownName("the property", property, names));
}

void noteChange(World& world, const SetProperty& intervention, const std::string& from, const std::string& to) {
  world.pending_events.push_back(
      {Event::Kind::kIntervention, intervention.entity, "", intervention.property + " from " + from + " to " + to});
}

bool setColor(World& world, const SetProperty& intervention, Row row) {
  Entities& entities = world.space.entities;
  const std::string what = intervention.property + " of " + describeEntity(entities, row);
  const Color color = parseColorOrThrow(intervention.value, what, {});
  if (color == entities.color[row]) {
    return false;
  }
  noteChange(world, intervention, toString(entities.color[row]), toString(color));
  entities.color[row] = color;
  return true;
}

}  // namespace

bool carryOut(World& world, const SetProperty& intervention) {
  const Entities& entities = world.space.entities;
  const Row row = world.space.entities.require(intervention.entity);
  const EntityModel& model = *entities.model[row];
  if (intervention.property == kColorProperty && model.hasColor()) {
    return setColor(world, intervention, row);
  }
  const int index = model.findProperty(intervention.property);
  if (index < 0) {
    refuseProperty(entities, row, intervention.property);
  }
  const auto place = static_cast<std::size_t>(index);
  const std::string what = intervention.property + " of " + describeEntity(entities, row);
  const double value = parseNumber(intervention.value, what, {}, model.properties[place].range);
  double& now = world.space.properties[row][place];
  if (value == now) {
    return false;
  }
  noteChange(world, intervention, numberText(now), numberText(value));
  now = value;
  return true;
}

}  // namespace swarmanoid
