// The top-level declarations of the schema: the plugins of the registry.
#include <algorithm>
#include <map>
#include <set>

#include "../reader/parameter_table.hpp"
#include "../reader/tags.hpp"
#include "schema_writer.hpp"
#include "swarmanoid_experiment_files/xml/xml_document.hpp"

namespace swarmanoid::experiment {

std::vector<std::string> tagsOf(const PluginDescription& plugin) {
  std::vector<std::string> tags = plugin.label_aliases;
  tags.insert(tags.begin(), plugin.label);
  const auto is_no_tag = [](const std::string& name) { return xmlValidateNCName(xmlCharacters(name.c_str()), 0) != 0; };
  tags.erase(std::remove_if(tags.begin(), tags.end(), is_no_tag), tags.end());
  return tags;
}

std::vector<ExperimentAttribute> attributesWithLibrary(const std::string& path,
                                                       const std::set<std::string>& libraries) {
  std::vector<ExperimentAttribute> attributes = tagAt(path).attributes;
  for (ExperimentAttribute& attribute : attributes) {
    if (attribute.value.name == "library" && !libraries.empty()) {
      attribute.value.value.reset();
    }
  }
  return attributes;
}

namespace {

std::vector<const Registry::Entry*> all(PluginKind kind) { return Registry::instance().all(kind); }

/// Declares the common children of all controllers.
void writeControllerParts(SchemaWriter& out) {
  for (const char* devices : {"actuators", "sensors"}) {
    out.openElement(devices, true);
    out.anyElements("lax");
    out.closeElement();
  }
  out.openElement("parameters", true, "Parameters of the controller.");
  out.anyElements("skip");
  out.closeElement();
}

bool areValuesAlike(const Parameter& one, const Parameter& other) {
  return one.type == other.type && one.range.minimum == other.range.minimum &&
         one.range.maximum == other.range.maximum && one.range.smallest_magnitude == other.range.smallest_magnitude &&
         one.choices == other.choices;
}

/// Returns the union of the implementations' parameters. For a parameter whose type or range differs among them only
/// the name is checked.
std::vector<Parameter> deviceParameters(const std::vector<const Registry::Entry*>& implementations) {
  std::vector<Parameter> table;
  for (const Registry::Entry* entry : implementations) {
    for (Parameter parameter : entry->description.parameters) {
      if (parameter.name == "implementation" || parameter.name == "realism" || parameter.name == "error") {
        continue;  // these names have another meaning in a device
      }
      if (implementations.size() > 1) {
        parameter.value = parameter.value.value_or("");  // other implementations may not need it
      }
      const auto known = std::find_if(table.begin(), table.end(),
                                      [&](const Parameter& other) { return other.name == parameter.name; });
      if (known == table.end()) {
        table.push_back(parameter);
        continue;
      }
      if (!areValuesAlike(*known, parameter)) {
        known->type = Parameter::Type::kText;
      }
      if (known->value != parameter.value) {
        known->value = "";
      }
    }
  }
  return table;
}

std::string summaryOf(const PluginDescription& plugin, const std::set<std::string>& libraries) {
  std::string summary = plugin.summary;
  for (const std::string& library : libraries) {
    summary += (summary.empty() ? "In library=\"" : " In library=\"") + library + "\".";
  }
  return summary;
}

/// Declares the contents of a device with a fixed set of parameters.
void writeDeviceParts(const std::vector<const Registry::Entry*>& implementations, SchemaWriter& out) {
  std::vector<std::string> choices;
  for (const Registry::Entry* entry : implementations) {
    const std::vector<std::string>& aliases = entry->description.implementation_aliases;
    choices.push_back(entry->description.implementation);
    choices.insert(choices.end(), aliases.begin(), aliases.end());
  }
  // <xs:all> cannot hold elements that occur several times; that values occur once is checked by the reader only
  out.open("choice", {{"minOccurs", "0"}, {"maxOccurs", "unbounded"}});
  out.choiceElement("implementation", choices);
  out.parameters({realismParameter()});
  out.parameters(deviceParameters(implementations));
  out.tag(tagAt("controllers/*/sensors/*/error"));
  out.close();
}

void writeDevice(const std::string& tag, const std::vector<const Registry::Entry*>& implementations,
                 const std::set<std::string>& libraries, SchemaWriter& out) {
  out.openElement(tag, true, summaryOf(implementations.front()->description, libraries));
  const bool is_free = std::any_of(implementations.begin(), implementations.end(),
                                   [](const Registry::Entry* entry) { return entry->description.free_parameters; });
  if (is_free) {
    out.anyElements("skip");
  } else {
    writeDeviceParts(implementations, out);
  }
  out.attributes(attributesWithLibrary("controllers/*/sensors/*", libraries));  // same as for actuators
  out.closeElement();
}

void writePlugin(PluginKind kind, const std::string& tag, const Registry::Entry& entry,
                 const std::set<std::string>& libraries, SchemaWriter& out) {
  out.openElement(tag, true, summaryOf(entry.description, libraries));
  if (kind == PluginKind::kController) {
    out.open("all");
    for (const char* part : {"actuators", "sensors", "parameters"}) {
      out.leaf("element", {{"ref", part}, {"minOccurs", "0"}});
    }
    out.parameters(tagAt("controllers/*").values);
    out.close();
  } else if (entry.description.free_parameters) {
    out.anyElements("skip");
  } else {
    out.open("all");
    out.parameters(entry.description.parameters);
    out.close();
  }
  out.attributes(attributesWithLibrary(pathOf(kind), libraries));
  out.closeElement();
}

/// Returns the libraries of which an experiment file must name one. The default library of a controller has the name of
/// its tag.
std::set<std::string> neededLibraries(PluginKind kind, const std::string& tag,
                                      const std::vector<const Registry::Entry*>& implementations,
                                      const PluginLibraries& libraries) {
  std::set<std::string> needed;
  for (const Registry::Entry* entry : implementations) {
    const auto found = libraries.find(entry);
    const std::string library = found == libraries.end() ? "" : found->second;
    if (library.empty() || (kind == PluginKind::kController && library == tag)) {
      return {};
    }
    needed.insert(library);
  }
  return needed;
}

constexpr PluginKind kKindsAtTop[] = {PluginKind::kController, PluginKind::kEngine,   PluginKind::kRule,
                                      PluginKind::kObserver,   PluginKind::kActuator, PluginKind::kSensor};

/// Returns the kinds of the plugins with each tag.
std::map<std::string, std::set<PluginKind>> kindsByTag() {
  std::map<std::string, std::set<PluginKind>> kinds;
  for (const PluginKind kind : kKindsAtTop) {
    for (const Registry::Entry* entry : all(kind)) {
      for (const std::string& tag : tagsOf(entry->description)) {
        kinds[tag].insert(kind);
      }
    }
  }
  return kinds;
}

/// Returns the plugins of a kind with the label; several are the implementations of a device, the default first.
std::vector<const Registry::Entry*> entriesOfLabel(PluginKind kind, const std::string& label) {
  std::vector<const Registry::Entry*> entries = all(kind);
  const auto is_other = [&](const Registry::Entry* entry) { return entry->description.label != label; };
  entries.erase(std::remove_if(entries.begin(), entries.end(), is_other), entries.end());
  std::stable_partition(entries.begin(), entries.end(),
                        [](const Registry::Entry* entry) { return entry->description.is_default; });
  return entries;
}

}  // namespace

void writePlugins(const PluginLibraries& libraries, SchemaWriter& out) {
  writeControllerParts(out);
  const auto kinds = kindsByTag();
  std::set<std::string> written{"ahss-config", "actuators", "sensors", "parameters"};
  for (const PluginKind kind : kKindsAtTop) {
    for (const Registry::Entry* entry : all(kind)) {
      const auto implementations = entriesOfLabel(kind, entry->description.label);
      for (const std::string& tag : tagsOf(entry->description)) {
        if (kinds.at(tag).size() > 1 || !written.insert(tag).second) {
          continue;
        }
        const auto needed = neededLibraries(kind, tag, implementations, libraries);
        if (kind == PluginKind::kActuator || kind == PluginKind::kSensor) {
          writeDevice(tag, implementations, needed, out);
        } else {
          writePlugin(kind, tag, *entry, needed, out);
        }
      }
    }
  }
}

}  // namespace swarmanoid::experiment
