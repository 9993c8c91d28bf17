// The XML schema of experiment files, made from the tables that the readers use.
//
// Sections that name plugins let unknown tags through, since any library may add one; known tags are checked at every
// place. XML Schema finds known tags among unknown ones only if they are declared at the top level.
#include <algorithm>
#include <set>

#include "../reader/parameter_table.hpp"
#include "../reader/tags.hpp"
#include "../robots/robot_files.hpp"
#include "schema_writer.hpp"
#include "swarmanoid_experiment_files/experiment_schema.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/models/entity_type.hpp"

namespace swarmanoid::experiment {
namespace {

/// The entity types that the schema knows.
struct EntityTypes {
  std::vector<const Registry::Entry*> all;
  const PluginLibraries& libraries;  ///< libraries that contain some of the types

  /// Returns the library that an experiment file must name for the type, if any.
  std::set<std::string> neededFor(const Registry::Entry* entry) const {
    const auto found = libraries.find(entry);
    return found == libraries.end() || found->second.empty() ? std::set<std::string>{}
                                                             : std::set<std::string>{found->second};
  }
};

void writeOpenSection(const std::string& name, SchemaWriter& out) {
  out.openElement(name, false);
  out.anyElements("lax");
  out.closeElement();
}

void writeEntities(const EntityTypes& types, bool is_distributed, SchemaWriter& out) {
  for (const Registry::Entry* entry : types.all) {
    for (const std::string& tag : tagsOf(entry->description)) {
      out.openElement(tag, false, entry->description.summary);
      out.open("all");
      out.parameters(entityParameters(entry->description, is_distributed));
      if (makePlugin<EntityType>(*entry)->isRobot()) {
        out.openElement("controller", false);
        out.open("simpleContent");
        out.open("extension", {{"base", "name"}});
        out.attributes(tagAt("arena/*/controller").attributes);
        out.close();
        out.close();
        out.closeElement();
      }
      out.close();
      out.attributes(attributesWithLibrary("arena/*", types.neededFor(entry)));
      out.closeElement();
    }
  }
}

void writeDistribute(const ExperimentTag& tag, const EntityTypes& types, SchemaWriter& out) {
  out.openElement(tag.name, true, tag.summary);
  out.open("all");
  out.parameters(tag.values);
  writeEntities(types, true, out);
  out.close();
  out.attributes(tag.attributes);
  out.closeElement();
}

void writeArena(const EntityTypes& types, SchemaWriter& out) {
  out.openElement("arena", true);
  out.open("choice", {{"minOccurs", "0"}, {"maxOccurs", "unbounded"}});
  writeEntities(types, false, out);
  for (const std::string& name : tagsIn("arena")) {
    const std::string path = "arena/" + name;
    const ExperimentTag& tag = tagAt(path);
    if (name == "distribute") {
      writeDistribute(tag, types, out);
    } else {
      out.tag(tag);
    }
  }
  out.close();
  out.attributes(tagAt("arena").attributes);
  out.closeElement();
}

void writeCondition(const ExperimentTag& tag, SchemaWriter& out) {
  if (tag.name != "debug") {
    out.tag(tag);
    return;
  }
  out.openElement(tag.name, true, tag.summary);
  out.open("simpleContent");
  out.open("extension", {{"base", "text"}});
  out.attributes(tag.attributes);
  out.close();
  out.close();
  out.closeElement();
}

void writeHandover(SchemaWriter& out) {
  const std::string path = "arena_physics/handover";
  const ExperimentTag& tag = tagAt(path);
  out.openElement(tag.name, true, tag.summary);
  out.open("choice");
  for (const std::string& name : tagsIn(path)) {
    writeCondition(tagAt(path + "/" + name), out);
  }
  out.close();
  out.attributes(tag.attributes);
  out.closeElement();
}

void writeArenaPhysics(SchemaWriter& out) {
  out.openElement("arena_physics", false);
  out.open("choice", {{"minOccurs", "0"}, {"maxOccurs", "unbounded"}});
  writeHandover(out);
  out.openRepeatedElement("engine");
  out.open("sequence");
  out.openRepeatedElement("entity");
  out.attributes(tagAt("arena_physics/engine/entity").attributes);
  out.closeElement();
  out.close();
  out.attributes(tagAt("arena_physics/engine").attributes);
  out.close();
  out.identity("unique", "entity_of_engine", "entity");
  out.close();
  out.close();
  out.closeElement();
}

void writeIdentities(const EntityTypes& types, SchemaWriter& out) {
  for (const char* section : {"controllers", "engines", "rules", "visualisations", "visualizations"}) {
    out.identity("unique", std::string("id_in_") + section, std::string(section) + "/*");
  }
  out.identity("unique", "id_in_arena", "arena/*|arena/distribute/*");
  out.identity("unique", "engine_of_mapping", "arena_physics/engine");
  out.identity("unique", "id_of_handover", "arena_physics/handover");
  std::string bodies;
  for (const Registry::Entry* entry : types.all) {
    for (const std::string& tag : tagsOf(entry->description)) {
      bodies += (bodies.empty() ? "arena/" : "|arena/") + tag;
      bodies += "|arena/distribute/" + tag;
    }
  }
  out.identity("key", "mapped_entity", bodies);
  out.reference("mapping", "mapped_entity", "arena_physics/engine/entity", "@id");
  out.reference("handed_over", "mapped_entity", "arena_physics/handover", "@entity");
}

void writeRoot(const EntityTypes& types, SchemaWriter& out) {
  out.openElement("ahss-config", true);
  out.open("all");
  out.openElement("framework", true);
  out.open("all");
  out.parameters(tagAt("framework").values);
  out.close();
  out.closeElement();
  writeOpenSection("controllers", out);
  writeArena(types, out);
  writeOpenSection("engines", out);
  writeArenaPhysics(out);
  writeOpenSection("rules", out);
  writeOpenSection("visualisations", out);
  writeOpenSection("visualizations", out);
  out.close();
  out.close();
  writeIdentities(types, out);
  out.close();
}

constexpr const char* kSuitesRobots = "swarmanoid_description";  // the package of the suite's robots

/// Returns whether the type is a robot that only packages outside the suite provide.
bool isOfOthers(const Registry::Entry* type) {
  if (!makePlugin<EntityType>(*type)->isRobot()) {
    return false;
  }
  const std::vector<RobotFile>& robots = robotFiles().robots;
  const auto is_it = [&](const RobotFile& robot) { return robot.type == type->description.label; };
  const auto is_suites = [&](const RobotFile& robot) { return is_it(robot) && robot.package == kSuitesRobots; };
  return std::any_of(robots.begin(), robots.end(), is_it) && std::none_of(robots.begin(), robots.end(), is_suites);
}

std::string writeSchema(const EntityTypes& types) {
  SchemaWriter out;
  writeRoot(types, out);
  writePlugins(types.libraries, out);
  return out.text();
}

}  // namespace
}  // namespace swarmanoid::experiment

namespace swarmanoid {

std::string experimentSchema(const PluginLibraries& libraries) {
  return experiment::writeSchema({Registry::instance().all(PluginKind::kEntity), libraries});
}

std::string suiteSchema() {
  for (const DeclaredLibrary& declared : declaredLibraries()) {
    if (declared.isOfSuite() && !declared.visualisations.empty()) {
      loadPluginLibrary(declared.library, {}, {});
    }
  }
  std::vector<const Registry::Entry*> types = Registry::instance().all(PluginKind::kEntity);
  types.erase(std::remove_if(types.begin(), types.end(), experiment::isOfOthers), types.end());
  const PluginLibraries none;
  return experiment::writeSchema({types, none});
}

}  // namespace swarmanoid
