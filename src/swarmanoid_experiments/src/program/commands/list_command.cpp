// `swarmanoid list`: the names that may be used in an experiment file.
#include <ostream>

#include "../commands.hpp"
#include "../installed_plugins.hpp"
#include "../output/parameter_text.hpp"
#include "../output/standard_output.hpp"
#include "swarmanoid_experiment_files/experiment_lookup.hpp"
#include "swarmanoid_experiment_files/experiment_tags.hpp"
#include "swarmanoid_experiment_files/realism.hpp"
#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/error_models/error_model.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid::program {
namespace {

void write(const Parameter& parameter, const std::string& type, std::ostream& out) {
  const std::string left_out = parameter.value && parameter.value->empty() ? "optional" : "required";
  out << "      " << parameter.name << (parameter.unit.empty() ? "" : " [" + parameter.unit + "]") << ", " << type
      << ", " << (parameter.value && !parameter.value->empty() ? "default '" + *parameter.value + "'" : left_out)
      << ": " << parameter.description << '\n';
}

void write(const ExperimentTag& tag, std::ostream& out) {
  out << "  " << (tag.name == "*" ? "each" : tag.name) << ": " << tag.summary << '\n';
  for (const ExperimentAttribute& attribute : tag.attributes) {
    write(attribute.value, "attribute, " + (attribute.is_id ? "a name" : allowedValues(attribute.value)), out);
  }
  for (const Parameter& value : tag.values) {
    write(value, allowedValues(value), out);
  }
}

void write(const ErrorKind& kind, std::ostream& out) {
  out << "  kind=\"" << kind.description.name << "\": " << kind.description.summary << '\n';
  for (const Parameter& parameter : kind.description.parameters) {
    write(parameter, "attribute, " + allowedValues(parameter), out);
  }
}

void write(const RealismPreset& preset, std::ostream& out) {
  out << "  " << preset.name << ": " << toString(preset.kind) << ' ' << preset.device << ": " << preset.source << '\n';
}

/// Writes the fields that controllers read from a sensor and write to an actuator.
void writeFields(const std::string& device, std::ostream& out) {
  const DeviceType* type = findDeviceType(device);
  if (type == nullptr) {
    return;
  }
  for (const FieldDescription& field : type->fields) {
    out << "      field " << describe(field) << (field.meaning.empty() ? "" : ": " + field.meaning) << '\n';
  }
}

void write(const PluginDescription& description, const DeclaredLibrary& origin, std::ostream& out) {
  out << "  " << description.label;
  if (!description.implementation.empty()) {
    const bool says_so = description.is_default && description.implementation != "default";
    out << " (" << description.implementation << (says_so ? ", default)" : ")");
  }
  out << (description.summary.empty() ? "" : ": " + description.summary) << '\n';
  if (!origin.library.empty()) {
    out << "      in library=\"" << origin.library << "\" of " << origin.package << '\n';
  }
  if (!description.label_aliases.empty() || !description.implementation_aliases.empty()) {
    out << "      also known as " << joinNames(description.label_aliases)
        << (description.label_aliases.empty() || description.implementation_aliases.empty() ? "" : "; ")
        << joinNames(description.implementation_aliases) << '\n';
  }
  if (!description.implementation.empty()) {
    writeFields(description.label, out);
  }
  for (const Parameter& parameter : description.parameters) {
    write(parameter, allowedValues(parameter), out);
  }
}

/// Returns the headings. Every tag is listed under one of them, and every plugin under its kind.
std::vector<std::string> headings() {
  std::vector<std::string> names{"experiment"};
  for (const ExperimentTag& tag : experimentTags()) {
    if (!contains(names, tag.heading)) {
      names.push_back(tag.heading);
    }
  }
  names.emplace_back("realism");
  return names;
}

void writeHeading(const std::string& heading, const PluginOrigins& origins, std::ostream& out) {
  out << heading << '\n';
  if (heading == "experiment") {
    for (const std::string& name : installedExperiments()) {
      out << "  " << name << '\n';
    }
  }
  for (const ExperimentTag& tag : experimentTags()) {
    if (tag.heading == heading) {
      write(tag, out);
    }
  }
  if (heading == "error") {
    for (const ErrorKind* kind : errorKinds()) {
      write(*kind, out);
    }
  }
  if (heading == "realism") {
    for (const RealismPreset& preset : realismPresets()) {
      write(preset, out);
    }
  }
  for (const Registry::Entry* entry : allPlugins()) {
    if (toString(entry->kind) == heading) {
      write(entry->description, origins.at(entry), out);
    }
  }
}

ExitCode list(const std::string& heading) {
  const std::vector<std::string> allowed = headings();
  const bool all = heading.empty();
  if (!all && !contains(allowed, heading)) {
    throw ConfigError({"list", 0},
                      "found '" + heading + "', allowed: " + joinNames(allowed) + didYouMean(heading, allowed));
  }
  const PluginOrigins origins = loadInstalledPlugins();
  PlainTextStream out;
  for (const std::string& name : all ? allowed : std::vector<std::string>{heading}) {
    writeHeading(name, origins, out);
  }
  print(out.str());
  return ExitCode::kFinished;
}

}  // namespace

Command addListCommand(CLI::App& app) {
  auto heading = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("list", "what can be named in an experiment file");
  command->add_option("kind", *heading, "one of " + joinNames(headings()) + "; else all");
  return [heading] { return list(*heading); };
}

}  // namespace swarmanoid::program
