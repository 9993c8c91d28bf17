// The XML schema of experiment files, made from the tables that the readers use.
//
// Sections that name plugins let unknown tags through, since anybody's library may add one; what is known is checked,
// wherever it stands. XML Schema finds known tags among unknown ones only if they are declared at the top.
#include <set>

#include "parameter_table.hpp"
#include "schema_writer.hpp"
#include "swarmanoid_space/entity_type.hpp"
#include "swarmanoid_space/experiment.hpp"

namespace swarmanoid::experiment {
namespace {

std::vector<std::string> namesOf(const std::string& name, std::vector<std::string> aliases) {
  aliases.insert(aliases.begin(), name);
  return aliases;
}

std::vector<const Registry::Entry*> all(PluginKind kind) { return Registry::instance().all(kind); }

std::vector<std::string> tagsOf(PluginKind kind) {
  std::vector<std::string> tags;
  for (const Registry::Entry* entry : all(kind)) {
    const auto names = namesOf(entry->description.label, entry->description.label_aliases);
    tags.insert(tags.end(), names.begin(), names.end());
  }
  return tags;
}

void writePluginAttributes(SchemaWriter& out) {
  for (const std::string& name : pluginAttributes()) {
    out.attribute(name, name == "id" ? "name" : "xs:string", name == "id");
  }
}

void writeOpenSection(const std::string& name, SchemaWriter& out) {
  out.openElement(name, false);
  out.anyElements("lax");
  out.closeElement();
}

void writeEntities(bool is_distributed, SchemaWriter& out) {
  for (const Registry::Entry* entry : all(PluginKind::kEntity)) {
    for (const std::string& tag : namesOf(entry->description.label, entry->description.label_aliases)) {
      out.openElement(tag, false, entry->description.summary);
      out.open("all");
      out.parameters(entityParameters(entry->description, is_distributed));
      if (makePlugin<EntityType>(*entry)->isRobot()) {
        out.leaf("element", {{"name", "controller"}, {"type", "name"}, {"minOccurs", "0"}});
      }
      out.close();
      out.attribute("id", "name", true);
      out.closeElement();
    }
  }
}

void writeArena(SchemaWriter& out) {
  out.openElement("arena", true);
  out.open("choice", {{"minOccurs", "0"}, {"maxOccurs", "unbounded"}});
  writeEntities(false, out);
  out.openElement("floor_patch", true);
  out.open("all");
  out.parameters(floorPatchParameters());
  out.close();
  out.attribute("id", "name", true);
  out.closeElement();
  out.openElement("distribute", true);
  out.open("all");
  out.parameters(distributeParameters());
  writeEntities(true, out);
  out.close();
  out.numberAttribute("quantity", kQuantityRange, true);
  out.choiceAttribute("layout", layouts(), false);
  out.closeElement();
  out.close();
  out.attribute("size", "three_numbers", true);
  out.choiceAttribute("optimization", optimizations(), true);
  out.attribute("bounded", "boolean", false);
  out.closeElement();
}

void writeArenaPhysics(SchemaWriter& out) {
  out.openElement("arena_physics", false);
  out.open("sequence");
  out.openRepeatedElement("engine");
  out.open("sequence");
  out.openRepeatedElement("entity");
  out.attribute("id", "name", true);
  out.choiceAttribute("role", roles(), false);
  out.closeElement();
  out.close();
  out.attribute("id", "name", true);
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
  std::string bodies;
  for (const std::string& tag : tagsOf(PluginKind::kEntity)) {
    bodies += (bodies.empty() ? "arena/" : "|arena/") + tag;
    bodies += "|arena/distribute/" + tag;
  }
  out.identity("key", "mapped_entity", bodies);
  out.reference("mapping", "mapped_entity", "arena_physics/engine/entity");
}

void writeRoot(SchemaWriter& out) {
  out.openElement("ahss-config", true);
  out.open("all");
  out.openElement("framework", true);
  out.open("all");
  out.parameters(frameworkParameters());
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

/// What stands in any controller, known or not.
void writeControllerParts(SchemaWriter& out) {
  for (const char* devices : {"actuators", "sensors"}) {
    out.openElement(devices, true);
    out.anyElements("lax");
    out.closeElement();
  }
  out.openElement("parameters", true, "Whatever the controller reads.");
  out.anyElements("skip");
  out.closeElement();
}

/// The values that one implementation or another reads; those that not all need are optional.
std::vector<Parameter> deviceParameters(const std::vector<const Registry::Entry*>& implementations) {
  std::vector<Parameter> table;
  std::set<std::string> names;
  for (const Registry::Entry* entry : implementations) {
    for (Parameter parameter : entry->description.parameters) {
      if (implementations.size() > 1) {
        // implementations may differ in what they allow, so only the name is sure
        parameter.type = Parameter::Type::kText;
        parameter.value = parameter.value.value_or("");
      }
      if (names.insert(parameter.name).second) {
        table.push_back(parameter);
      }
    }
  }
  return table;
}

void writeDevice(const std::string& tag, const std::vector<const Registry::Entry*>& implementations,
                 SchemaWriter& out) {
  std::vector<std::string> choices;
  for (const Registry::Entry* entry : implementations) {
    const auto names = namesOf(entry->description.implementation, entry->description.implementation_aliases);
    choices.insert(choices.end(), names.begin(), names.end());
  }
  out.openElement(tag, true, implementations.front()->description.summary);
  out.open("all");
  out.choiceElement("implementation", choices);
  out.parameters(deviceParameters(implementations));
  out.close();
  out.attribute("library", "xs:string", false);
  out.closeElement();
}

void writePlugin(PluginKind kind, const std::string& tag, const Registry::Entry& entry, SchemaWriter& out) {
  out.openElement(tag, true, entry.description.summary);
  out.open("all");
  if (kind == PluginKind::kController) {
    for (const char* part : {"actuators", "sensors", "parameters"}) {
      out.leaf("element", {{"ref", part}, {"minOccurs", "0"}});
    }
  } else {
    out.parameters(entry.description.parameters);
  }
  out.close();
  writePluginAttributes(out);
  out.closeElement();
}

void writePlugins(SchemaWriter& out) {
  std::set<std::string> written{"ahss-config", "actuators", "sensors", "parameters"};
  for (const PluginKind kind : {PluginKind::kController, PluginKind::kEngine, PluginKind::kVisualisation,
                                PluginKind::kActuator, PluginKind::kSensor}) {
    const bool is_device = kind == PluginKind::kActuator || kind == PluginKind::kSensor;
    for (const Registry::Entry* entry : all(kind)) {
      std::vector<const Registry::Entry*> implementations;
      for (const Registry::Entry* other : all(kind)) {
        if (other->description.label == entry->description.label) {
          implementations.push_back(other);
        }
      }
      for (const std::string& tag : namesOf(entry->description.label, entry->description.label_aliases)) {
        if (!written.insert(tag).second) {
          continue;
        }
        if (is_device) {
          writeDevice(tag, implementations, out);
        } else {
          writePlugin(kind, tag, *entry, out);
        }
      }
    }
  }
}

}  // namespace
}  // namespace swarmanoid::experiment

namespace swarmanoid {

std::string experimentSchema() {
  experiment::SchemaWriter out;
  experiment::writeRoot(out);
  experiment::writeControllerParts(out);
  experiment::writePlugins(out);
  return out.text();
}

}  // namespace swarmanoid
