// `swarmanoid list` and `swarmanoid schema`: what can stand in an experiment file.
#include <iostream>

#include "commands.hpp"
#include "run_summary.hpp"
#include "swarmanoid_interface/registry.hpp"
#include "swarmanoid_space/experiment.hpp"
#include "swarmanoid_space/experiment_lookup.hpp"

namespace swarmanoid::program {
namespace {

constexpr PluginKind kKinds[] = {PluginKind::kController, PluginKind::kSensor,        PluginKind::kActuator,
                                 PluginKind::kEngine,     PluginKind::kVisualisation, PluginKind::kEntity};

std::string withRange(const Parameter& parameter) {
  switch (parameter.type) {
    case Parameter::Type::kChoice:
      return "one of " + joinNames(parameter.choices);
    case Parameter::Type::kNumber:
    case Parameter::Type::kInteger:
    case Parameter::Type::kAngle:
      return parameter.range.toString();
    case Parameter::Type::kBoolean:
      return "true, false";
    case Parameter::Type::kColor:
      return "a colour";
    case Parameter::Type::kVector2:
      return "two numbers";
    case Parameter::Type::kVector3:
    case Parameter::Type::kAngles3:
      return "three numbers";
    case Parameter::Type::kText:
      return "text";
  }
  return "";
}

void print(const PluginDescription& description) {
  std::cout << "  " << description.label;
  if (!description.implementation.empty()) {
    std::cout << " (" << description.implementation << ")";
  }
  std::cout << ": " << description.summary << '\n';
  if (!description.label_aliases.empty() || !description.implementation_aliases.empty()) {
    std::cout << "      also known as " << joinNames(description.label_aliases)
              << (description.label_aliases.empty() || description.implementation_aliases.empty() ? "" : "; ")
              << joinNames(description.implementation_aliases) << '\n';
  }
  for (const Parameter& parameter : description.parameters) {
    std::cout << "      " << parameter.name << (parameter.unit.empty() ? "" : " [" + parameter.unit + "]") << ", "
              << withRange(parameter) << ", "
              << (parameter.value ? "default '" + *parameter.value + "'" : std::string("required")) << ": "
              << parameter.description << '\n';
  }
}

int list(const std::string& kind_name) {
  loadBuiltInPlugins();
  std::vector<std::string> allowed{"experiment"};
  for (const PluginKind kind : kKinds) {
    allowed.emplace_back(toString(kind));
  }
  const bool all = kind_name.empty();
  if (!all && std::find(allowed.begin(), allowed.end(), kind_name) == allowed.end()) {
    throw ConfigError({"list", 0},
                      "found '" + kind_name + "', allowed: " + joinNames(allowed) + didYouMean(kind_name, allowed));
  }
  if (all || kind_name == "experiment") {
    std::cout << "experiment\n";
    for (const std::string& name : installedExperiments()) {
      std::cout << "  " << name << '\n';
    }
  }
  for (const PluginKind kind : kKinds) {
    if (all || kind_name == toString(kind)) {
      std::cout << toString(kind) << '\n';
      for (const auto* entry : Registry::instance().all(kind)) {
        print(entry->description);
      }
    }
  }
  return kFinished;
}

}  // namespace

Command addListCommand(CLI::App& app) {
  auto kind = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("list", "what can be named in an experiment file");
  command->add_option("kind", *kind, "experiment, controller, sensor, actuator, engine, visualisation or entity");
  return [kind] { return list(*kind); };
}

Command addSchemaCommand(CLI::App& app) {
  app.add_subcommand("schema", "print the XML schema (XSD) of experiment files");
  return [] {
    loadBuiltInPlugins();
    std::cout << experimentSchema();
    return static_cast<int>(kFinished);
  };
}

}  // namespace swarmanoid::program
