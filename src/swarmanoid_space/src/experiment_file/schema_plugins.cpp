// The part of the schema that stands at its top: whatever plugins the registry knows.
#include <set>

#include "parameter_table.hpp"
#include "schema_writer.hpp"
#include "tags.hpp"

namespace swarmanoid::experiment {

std::vector<std::string> namesOf(const std::string& name, std::vector<std::string> aliases) {
  aliases.insert(aliases.begin(), name);
  return aliases;
}

namespace {

std::vector<const Registry::Entry*> all(PluginKind kind) { return Registry::instance().all(kind); }

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
  // <xs:all> cannot hold what stands there several times, so that values stand there once is left to the reader
  out.open("choice", {{"minOccurs", "0"}, {"maxOccurs", "unbounded"}});
  out.choiceElement("implementation", choices);
  out.parameters(deviceParameters(implementations));
  out.tag(tagAt("controllers/*/sensors/*/error"));
  out.close();
  out.attributes(tagAt("controllers/*/sensors/*").attributes);  // and actuators have the same
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
  out.attributes(tagAt("controllers/*").attributes);  // and engines and visualisations have the same
  out.closeElement();
}

}  // namespace

void writePlugins(SchemaWriter& out) {
  writeControllerParts(out);
  std::set<std::string> written{"ahss-config", "actuators", "sensors", "parameters"};
  for (const PluginKind kind : {PluginKind::kController, PluginKind::kEngine, PluginKind::kObserver,
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

}  // namespace swarmanoid::experiment
