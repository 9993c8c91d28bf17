// The XML schema of experiment files, made from the tables that the readers use.
//
// Sections that name plugins let unknown tags through, since anybody's library may add one; what is known is checked,
// wherever it stands. XML Schema finds known tags among unknown ones only if they are declared at the top.
#include "parameter_table.hpp"
#include "schema_writer.hpp"
#include "swarmanoid_space/experiment_file/experiment.hpp"
#include "swarmanoid_space/models/entity_type.hpp"
#include "tags.hpp"

namespace swarmanoid::experiment {
namespace {

std::vector<std::string> tagsOf(PluginKind kind) {
  std::vector<std::string> tags;
  for (const Registry::Entry* entry : Registry::instance().all(kind)) {
    const auto names = namesOf(entry->description.label, entry->description.label_aliases);
    tags.insert(tags.end(), names.begin(), names.end());
  }
  return tags;
}

void writeOpenSection(const std::string& name, SchemaWriter& out) {
  out.openElement(name, false);
  out.anyElements("lax");
  out.closeElement();
}

void writeEntities(bool is_distributed, SchemaWriter& out) {
  for (const Registry::Entry* entry : Registry::instance().all(PluginKind::kEntity)) {
    for (const std::string& tag : namesOf(entry->description.label, entry->description.label_aliases)) {
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
      out.attributes(tagAt("arena/*").attributes);
      out.closeElement();
    }
  }
}

void writeDistribute(const ExperimentTag& tag, SchemaWriter& out) {
  out.openElement(tag.name, true, tag.summary);
  out.open("all");
  out.parameters(tag.values);
  writeEntities(true, out);
  out.close();
  out.attributes(tag.attributes);
  out.closeElement();
}

void writeArena(SchemaWriter& out) {
  out.openElement("arena", true);
  out.open("choice", {{"minOccurs", "0"}, {"maxOccurs", "unbounded"}});
  writeEntities(false, out);
  for (const std::string& name : tagsIn("arena")) {
    const std::string path = "arena/" + name;
    const ExperimentTag& tag = tagAt(path);
    if (name == "distribute") {
      writeDistribute(tag, out);
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

void writeIdentities(SchemaWriter& out) {
  for (const char* section : {"controllers", "engines", "visualisations", "visualizations"}) {
    out.identity("unique", std::string("id_in_") + section, std::string(section) + "/*");
  }
  out.identity("unique", "id_in_arena", "arena/*|arena/distribute/*");
  out.identity("unique", "engine_of_mapping", "arena_physics/engine");
  out.identity("unique", "id_of_handover", "arena_physics/handover");
  std::string bodies;
  for (const std::string& tag : tagsOf(PluginKind::kEntity)) {
    bodies += (bodies.empty() ? "arena/" : "|arena/") + tag;
    bodies += "|arena/distribute/" + tag;
  }
  out.identity("key", "mapped_entity", bodies);
  out.reference("mapping", "mapped_entity", "arena_physics/engine/entity", "@id");
  out.reference("handed_over", "mapped_entity", "arena_physics/handover", "@entity");
}

void writeRoot(SchemaWriter& out) {
  out.openElement("ahss-config", true);
  out.open("all");
  out.openElement("framework", true);
  out.open("all");
  out.parameters(tagAt("framework").values);
  out.close();
  out.closeElement();
  writeOpenSection("controllers", out);
  writeArena(out);
  writeOpenSection("engines", out);
  writeArenaPhysics(out);
  writeOpenSection("visualisations", out);
  writeOpenSection("visualizations", out);
  out.close();
  out.close();
  writeIdentities(out);
  out.close();
}

}  // namespace
}  // namespace swarmanoid::experiment

namespace swarmanoid {

std::string experimentSchema() {
  experiment::SchemaWriter out;
  experiment::writeRoot(out);
  experiment::writePlugins(out);
  return out.text();
}

}  // namespace swarmanoid
