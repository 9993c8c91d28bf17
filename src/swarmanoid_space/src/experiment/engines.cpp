// <engines> and <arena_physics>: which engines there are, and which entity is in which.
#include <algorithm>
#include <set>

#include "reader.hpp"

namespace swarmanoid::experiment {

void readEngines(const XmlElement& section, Reader& reader) {
  section.allowAttributes({});
  section.refuseText();
  for (const XmlElement& element : section.children()) {
    element.allowAttributes(attributesOf("engines/*"));
    EngineDescription engine;
    engine.location = element.location();
    engine.id = element.requireAttribute("id");
    engine.library = element.attribute("library").value_or("");
    reader.takeId("engine", engine.id, element);
    const Registry::Entry& entry = reader.requirePlugin(PluginKind::kEngine, element, engine.library);
    engine.label = entry.description.label;
    engine.parameters = readPluginParameters(element, entry.description);
    reader.experiment.engines.push_back(std::move(engine));
  }
}

namespace {

MappingDescription::Member readMember(const XmlElement& element, const std::vector<std::string>& entities) {
  element.allowAttributes(attributesOf("arena_physics/engine/entity"));
  element.allowChildren({});
  MappingDescription::Member member;
  member.location = element.location();
  member.entity = element.requireAttribute("id");
  if (std::find(entities.begin(), entities.end(), member.entity) == entities.end()) {
    throw ConfigError(element.attributeLocation("id"), unknownName("the entity", member.entity, entities));
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
  std::vector<std::string> engines;
  for (const EngineDescription& engine : reader.experiment.engines) {
    engines.push_back(engine.id);
  }
  std::vector<std::string> entities;
  for (const EntityDescription& entity : reader.experiment.arena.entities) {
    entities.push_back(entity.id);
  }
  std::set<std::string> moved;
  std::set<std::string> mapped;
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
    if (std::find(engines.begin(), engines.end(), mapping.engine) == engines.end()) {
      throw ConfigError(element.attributeLocation("id"), unknownName("the engine", mapping.engine, engines));
    }
    for (const MappingDescription& other : reader.experiment.mappings) {
      if (other.engine == mapping.engine) {
        element.refuse("found the engine '" + mapping.engine + "' twice, allowed: once");
      }
    }
    for (const XmlElement& child : element.children()) {
      mapping.members.push_back(readMember(child, entities));
      const MappingDescription::Member& member = mapping.members.back();
      if (!mapped.insert(mapping.engine + " " + member.entity).second) {
        child.refuse("found the entity '" + member.entity + "' twice in the engine '" + mapping.engine +
                     "', allowed: once");
      }
      if (member.role == Role::kMove && !moved.insert(member.entity).second) {
        child.refuse("found a second role=\"move\" for the entity '" + member.entity +
                     "', allowed: one engine moves it");
      }
    }
    reader.experiment.mappings.push_back(std::move(mapping));
  }
}

}  // namespace swarmanoid::experiment
