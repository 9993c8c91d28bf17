#include "engine_config.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

namespace swarmanoid {
namespace {

using dynamic_reconfigure::Config;

constexpr const char* kGroup = "Default";  // the name that clients expect if there is only one group
constexpr const char* kLastError = "last_error";

bool isDouble(const Parameter& parameter) {
  return parameter.type == Parameter::Type::kNumber || parameter.type == Parameter::Type::kAngle;
}

/// Returns "{'enum': [...]}" for a choice, which clients show as a list; "" otherwise.
std::string editMethod(const Parameter& parameter) {
  if (parameter.type != Parameter::Type::kChoice) {
    return "";
  }
  std::string values;
  for (const std::string& choice : parameter.choices) {
    values += std::string(values.empty() ? "" : ", ") + "{'name': '" + choice + "', 'type': 'str', 'value': '" +
              choice + "', 'description': ''}";
  }
  return "{'enum': [" + values + "], 'enum_description': ''}";
}

dynamic_reconfigure::ParamDescription describe(const Parameter& parameter) {
  dynamic_reconfigure::ParamDescription result;
  result.name = parameter.name;
  result.type = isDouble(parameter)                           ? "double"
                : parameter.type == Parameter::Type::kInteger ? "int"
                : parameter.type == Parameter::Type::kBoolean ? "bool"
                                                              : "str";
  result.description = parameter.description + (parameter.unit.empty() ? "" : " [" + parameter.unit + "]");
  result.edit_method = editMethod(parameter);
  return result;
}

template <class Entry, class Value>
void add(std::vector<Entry>& list, const std::string& name, Value value) {
  Entry entry;
  entry.name = name;
  entry.value = value;
  list.push_back(entry);
}

std::int32_t toInteger(double value) {
  constexpr double kMost = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int32_t>(std::clamp(value, -kMost, kMost));
}

void add(Config& config, const Parameter& parameter, const std::string& text) {
  if (isDouble(parameter)) {
    add(config.doubles, parameter.name, parseNumber(text, parameter.name, {}));
  } else if (parameter.type == Parameter::Type::kInteger) {
    add(config.ints, parameter.name, toInteger(static_cast<double>(parseInteger(text, parameter.name, {}))));
  } else if (parameter.type == Parameter::Type::kBoolean) {
    add(config.bools, parameter.name, parseBoolean(text, parameter.name, {}));
  } else {
    add(config.strs, parameter.name, text);
  }
}

/// Returns the minimum or the maximum values of the ranges.
Config limits(const std::vector<Parameter>& parameters, bool is_least) {
  Config config;
  for (const Parameter& parameter : parameters) {
    const double limit = is_least ? parameter.range.minimum : parameter.range.maximum;
    if (isDouble(parameter)) {
      add(config.doubles, parameter.name, limit);
    } else if (parameter.type == Parameter::Type::kInteger) {
      add(config.ints, parameter.name, toInteger(limit));
    } else if (parameter.type == Parameter::Type::kBoolean) {
      add(config.bools, parameter.name, !is_least);
    } else {
      add(config.strs, parameter.name, "");
    }
  }
  add(config.strs, kLastError, "");
  return config;
}

dynamic_reconfigure::ParamDescription describeLastError() {
  dynamic_reconfigure::ParamDescription result;
  result.name = kLastError;
  result.type = "str";
  result.description = "Why the last change was refused; empty: it was made. To set it does nothing.";
  return result;
}

void addGroup(Config& config) {
  dynamic_reconfigure::GroupState group;
  group.name = kGroup;
  group.state = 1;
  config.groups = {group};
}

}  // namespace

dynamic_reconfigure::ConfigDescription describe(const std::vector<Parameter>& parameters) {
  dynamic_reconfigure::ConfigDescription result;
  dynamic_reconfigure::Group group;
  group.name = kGroup;
  NamedValues defaults;
  for (const Parameter& parameter : parameters) {
    group.parameters.push_back(describe(parameter));
    defaults.emplace_back(parameter.name, parameter.value.value_or(""));
  }
  group.parameters.push_back(describeLastError());
  result.groups = {group};
  result.min = limits(parameters, true);
  result.max = limits(parameters, false);
  result.dflt = toConfig(parameters, defaults, "");
  addGroup(result.min);
  addGroup(result.max);
  return result;
}

Config toConfig(const std::vector<Parameter>& parameters, const NamedValues& values, const std::string& last_error) {
  Config config;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    add(config, parameters[i], values[i].second);
  }
  add(config.strs, kLastError, last_error);
  addGroup(config);
  return config;
}

NamedValues fromConfig(const Config& config) {
  NamedValues values;
  for (const auto& entry : config.doubles) {
    values.emplace_back(entry.name, numberText(entry.value));
  }
  for (const auto& entry : config.ints) {
    values.emplace_back(entry.name, std::to_string(entry.value));
  }
  for (const auto& entry : config.bools) {
    values.emplace_back(entry.name, entry.value != 0 ? "true" : "false");
  }
  for (const auto& entry : config.strs) {
    if (entry.name != kLastError) {
      values.emplace_back(entry.name, entry.value);
    }
  }
  return values;
}

NamedValues valuesOf(const std::vector<Parameter>& parameters, const Configuration& configuration) {
  NamedValues values;
  for (const Parameter& parameter : parameters) {
    values.emplace_back(parameter.name, configuration.text(parameter.name, parameter.value.value_or("")));
  }
  return values;
}

}  // namespace swarmanoid
