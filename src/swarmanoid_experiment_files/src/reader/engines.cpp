// <engines> and <arena_physics>: the engines of the experiment, and the assignment of entities to them.
#include "reader.hpp"
#include "swarmanoid_space/experiment/entity_parameters.hpp"
#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid::experiment {

void readEngines(const XmlElement& section, Reader& reader) {
  reader.experiment.engines = readPluginUses(section, PluginKind::kEngine, reader);
  const std::vector<EngineDescription>& engines = reader.experiment.engines;
  if (engines.size() > limits::kMostEngines) {
    throw ConfigError(engines[limits::kMostEngines].location,
                      "found more than " + std::to_string(limits::kMostEngines) + " engines, allowed: at most as many");
  }
}

namespace {

MappingDescription::Member readMember(const XmlElement& element, const KnownNames& entities) {
  element.allowAttributes(attributesOf("arena_physics/engine/entity"));
  element.allowChildren({});
  MappingDescription::Member member;
  member.location = element.location();
  member.entity = element.requireAttribute("id");
  if (!entities.has(member.entity)) {
    throw ConfigError(element.attributeLocation("id"), unknownName("the entity", member.entity, entities.all));
  }
  if (const auto role = element.attribute("role")) {
    Parameter choice = makeParameter("role", Parameter::Type::kChoice, "", std::nullopt, {}, "");
    choice.choices = roles();
    checkValue(choice, *role, element.attributeLocation("role"));
    member.role = *role == "move" ? Role::kMove : Role::kMirror;
  }
  return member;
}

}  // namespace

void readArenaPhysics(const XmlElement& section, Reader& reader) {
  section.allowAttributes({});
  section.allowChildren(tagsIn("arena_physics"));
  KnownNames engines;
  for (const EngineDescription& engine : reader.experiment.engines) {
    engines.add(engine.id);
  }
  KnownNames entities;
  for (const EntityDescription& entity : reader.experiment.arena.entities) {
    entities.add(entity.id);
  }
  for (const XmlElement& element : section.children()) {
    if (element.name() == "handover") {
      readHandover(element, entities, engines, reader);
      continue;
    }
    element.allowAttributes(attributesOf("arena_physics/engine"));
    element.allowChildren(tagsIn("arena_physics/engine"));
    MappingDescription mapping;
    mapping.location = element.location();
    mapping.engine = element.requireAttribute("id");
    if (!engines.has(mapping.engine)) {
      throw ConfigError(element.attributeLocation("id"), unknownName("the engine", mapping.engine, engines.all));
    }
    for (const MappingDescription& other : reader.experiment.mappings) {
      if (other.engine == mapping.engine) {
        element.refuse("found the engine '" + mapping.engine + "' twice, allowed: once");
      }
    }
    for (const XmlElement& child : element.children()) {
      mapping.members.push_back(readMember(child, entities));  // duplicates are refused when the space is built
    }
    reader.experiment.mappings.push_back(std::move(mapping));
  }
}

}  // namespace swarmanoid::experiment
