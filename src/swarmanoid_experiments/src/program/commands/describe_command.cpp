// `swarmanoid describe`: the documentation of devices in the code, as Markdown. Each section of a device in
// docs/reference/devices/ starts with it, its headings one level lower.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "../commands.hpp"
#include "../installed_plugins.hpp"
#include "../output/markdown_table.hpp"
#include "../output/parameter_text.hpp"
#include "../output/standard_output.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/realism.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_space/engine.hpp"
#include "swarmanoid_space/experiment/experiment.hpp"
#include "swarmanoid_space/models/entity_model.hpp"
#include "swarmanoid_space/models/entity_type.hpp"

namespace swarmanoid::program {
namespace {

/// The implementations of a device.
using Implementations = std::vector<const Registry::Entry*>;

/// Returns all registered devices, by type.
std::map<std::string, Implementations> registeredDevices() {
  std::map<std::string, Implementations> devices;
  for (const PluginKind kind : {PluginKind::kSensor, PluginKind::kActuator}) {
    for (const Registry::Entry* entry : Registry::instance().all(kind)) {
      devices[entry->description.label].push_back(entry);
    }
  }
  return devices;
}

std::string asCode(const std::string& text) { return "`" + text + "`"; }

std::string asCode(std::vector<std::string> names) {
  std::transform(names.begin(), names.end(), names.begin(), [](const std::string& name) { return asCode(name); });
  return joinNames(names);
}

std::string rangeOf(const FieldDescription& field) {
  if (field.range.minimum == -M_PI && field.range.maximum == M_PI) {
    return field.wraps ? "(-pi, pi]" : "from -pi to pi";
  }
  if (field.range.minimum == -M_PI / 2.0 && field.range.maximum == M_PI / 2.0) {
    return "from -pi/2 to pi/2";
  }
  const std::string range = field.range.toString();
  return range == Range().toString() ? "" : range;
}

/// @return "" for the elements of a list, which is empty at rest
std::string restingValueOf(const FieldDescription& field) {
  constexpr int kDigits = 6;
  if (field.count == 0) {
    return "";
  }
  if (typeName(field) == "bool") {
    return field.resting_value == 0.0 ? "false" : "true";
  }
  return shortNumber(field.resting_value, kDigits);
}

/// All columns except the name.
std::vector<std::string> columnsOf(const FieldDescription& field) {
  return {asCode(typeName(field)), field.unit, rangeOf(field), restingValueOf(field), field.meaning};
}

/// Returns "ring[12]" for "ring[12].red"; "" for a field outside structs.
std::string structOf(const FieldDescription& field) {
  const std::string name = countedName(field);
  const std::size_t point = name.rfind('.');
  return point == std::string::npos ? "" : name.substr(0, point);
}

/// Fields of one struct that differ only in their names, such as red, green and blue, share a row.
MarkdownTable fieldTable(const std::vector<FieldDescription>& fields) {
  MarkdownTable table({"field", "type", "unit", "range", "at rest", "meaning"});
  for (std::size_t i = 0; i < fields.size();) {
    const std::string outer = structOf(fields[i]);
    const std::vector<std::string> columns = columnsOf(fields[i]);
    std::string names = asCode(countedName(fields[i]));
    std::size_t next = i + 1;
    for (; next < fields.size() && !outer.empty() && structOf(fields[next]) == outer &&
           columnsOf(fields[next]) == columns;
         ++next) {
      names += ", " + asCode(countedName(fields[next]).substr(outer.size()));
    }
    i = next;
    std::vector<std::string> row{names};
    row.insert(row.end(), columns.begin(), columns.end());
    table.add(row);
  }
  return table;
}

MarkdownTable parameterTable(const std::vector<Parameter>& parameters) {
  MarkdownTable table({"parameter", "default", "unit", "range", "meaning"});
  for (const Parameter& parameter : parameters) {
    const std::string left_out = parameter.value ? "optional" : "required";
    const bool has_default = parameter.value && !parameter.value->empty();
    table.add({asCode(parameter.name), has_default ? *parameter.value : left_out, parameter.unit,
               allowedValues(parameter), parameter.description});
  }
  return table;
}

/// Returns the models of the robots that may have the device.
std::vector<std::shared_ptr<const EntityModel>> robotsWith(const std::string& device) {
  const DeviceType* type = findDeviceType(device);
  std::vector<std::shared_ptr<const EntityModel>> models;
  for (const Registry::Entry* entry : Registry::instance().all(PluginKind::kEntity)) {
    const std::string& robot = entry->description.label;
    const bool may_have_it = type == nullptr || type->robot.empty() || type->robot == robot;
    if (!may_have_it || !makePlugin<EntityType>(*entry)->isRobot()) {
      continue;
    }
    try {
      models.push_back(robotModel(robot));
    } catch (const ConfigError&) {
      // `list` reports robots with invalid descriptions; the other robots suffice here
    }
  }
  return models;
}

/// Returns the engines that can move at least one of the installed robots with the device.
std::vector<std::string> enginesOf(const PluginDescription& device) {
  const auto models = robotsWith(device.label);
  std::vector<std::string> labels;
  for (const Registry::Entry* entry : Registry::instance().all(PluginKind::kEngine)) {
    const auto engine = makePlugin<Engine>(*entry);
    if (std::any_of(models.begin(), models.end(), [&](const std::shared_ptr<const EntityModel>& model) {
          return engine->unsupportedReason(*model, {{device.label, device.mechanisms}}).empty();
        })) {
      labels.push_back(entry->description.label);
    }
  }
  return labels;
}

std::string nameOf(const Mechanism& mechanism) {
  switch (mechanism.kind) {
    case Mechanism::Kind::kWheels:
      return "wheels";
    case Mechanism::Kind::kFlight:
      return "flight";
    case Mechanism::Kind::kJoint:
      return mechanism.name.empty() ? "joints" : "joint " + asCode(mechanism.name);
    case Mechanism::Kind::kHolder:
      return mechanism.name.empty() ? "holders" : "holder " + asCode(mechanism.name);
  }
  return "";
}

void writeImplementation(const PluginDescription& description, bool is_only_one, std::ostream& out) {
  out << "\n## Implementation " << asCode(description.implementation) << "\n\n" << description.summary << "\n\n";
  if (!is_only_one && description.is_default) {
    out << "- The default: an experiment that names none means this one\n";
  }
  const std::vector<std::string> engines = enginesOf(description);
  out << "- Engines: " << (engines.empty() ? "none" : asCode(engines)) << '\n';
  if (!description.mechanisms.empty()) {
    std::vector<std::string> names;
    for (const Mechanism& mechanism : description.mechanisms) {
      names.push_back(nameOf(mechanism));
    }
    out << "- Mechanisms: " << joinNames(names) << '\n';
  }
  if (!description.implementation_aliases.empty()) {
    out << "- Also known as " << asCode(description.implementation_aliases) << '\n';
  }
  out << '\n'
      << (description.parameters.empty() ? "It has no parameters.\n" : parameterTable(description.parameters).text());
}

/// Writes the presets of a device, as they stand in an experiment file.
void writePresets(const std::string& device, PluginKind kind, std::ostream& out) {
  for (const RealismPreset& preset : realismPresets()) {
    if (preset.device != device || preset.kind != kind) {
      continue;
    }
    out << "\n## Preset " << asCode(preset.name) << "\n\n" << preset.source << "\n\n";
    std::istringstream lines(preset.content);
    for (std::string line; std::getline(lines, line);) {
      out << "    " << line << '\n';
    }
  }
}

void writeDevice(const std::string& name, const Implementations& implementations, std::ostream& out) {
  const DeviceType* type = findDeviceType(name);
  const PluginDescription& first = implementations.front()->description;
  const bool is_sensor = implementations.front()->kind == PluginKind::kSensor;
  out << "# " << name << "\n\n"
      << (is_sensor ? "Sensor. " : "Actuator. ") << (type == nullptr ? first.summary : type->summary) << "\n\n";
  if (type != nullptr) {
    out << "- Robot: " << (type->robot.empty() ? "any" : asCode(type->robot)) << '\n'
        << "- Struct: " << asCode(type->name) << " of " << asCode(type->header) << '\n';
  }
  if (!first.label_aliases.empty()) {
    out << "- Also known as " << asCode(first.label_aliases) << '\n';
  }
  if (type != nullptr && !type->fields.empty()) {
    out << '\n' << fieldTable(type->fields).text();
  }
  for (const Registry::Entry* entry : implementations) {
    writeImplementation(entry->description, implementations.size() == 1, out);
  }
  writePresets(name, implementations.front()->kind, out);
}

/// @param device its type; "": all devices of the suite
ExitCode describeDevices(const std::string& device) {
  loadBuiltInPlugins();
  auto devices = registeredDevices();
  if (!device.empty() && devices.count(device) == 0) {
    loadInstalledPlugins();
    devices = registeredDevices();
  }
  if (!device.empty() && devices.count(device) == 0) {
    std::vector<std::string> known;
    for (const auto& [name, implementations] : devices) {
      known.push_back(name);
    }
    throw ConfigError({"describe", 0}, unknownName("the device", device, known));
  }
  PlainTextStream out;
  for (const auto& [name, implementations] : devices) {
    if (device.empty() || name == device) {
      out << (out.tellp() > 0 ? "\n" : "");
      writeDevice(name, implementations, out);
    }
  }
  print(out.str());
  return ExitCode::kFinished;
}

}  // namespace

Command addDescribeCommand(CLI::App& app) {
  auto device = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("describe", "print what a device reads or is commanded, as Markdown");
  command->add_option("device", *device, "its type, such as proximity; else all devices of the suite");
  return [device] { return describeDevices(*device); };
}

}  // namespace swarmanoid::program
