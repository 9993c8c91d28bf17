#include "swarmanoid_interface/registry.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/process/user_code.hpp"

namespace swarmanoid {

void checkValue(const Parameter& parameter, const std::string& text, const SourceLocation& location) {
  switch (parameter.type) {
    case Parameter::Type::kNumber:
    case Parameter::Type::kAngle:
      parseNumber(text, parameter.name, location, parameter.range);
      break;
    case Parameter::Type::kInteger:
      parseInteger(text, parameter.name, location, parameter.range);
      break;
    case Parameter::Type::kBoolean:
      parseBoolean(text, parameter.name, location);
      break;
    case Parameter::Type::kVector2:
      parseNumbers(text, 2, parameter.name, location, parameter.range);
      break;
    case Parameter::Type::kVector3:
    case Parameter::Type::kAngles3:
      parseNumbers(text, 3, parameter.name, location, parameter.range);
      break;
    case Parameter::Type::kColor:
      parseColorOrThrow(text, parameter.name, location);
      break;
    case Parameter::Type::kChoice:
      if (!contains(parameter.choices, text)) {
        throw ConfigError(location, parameter.name + ": " + unknownName("the value", text, parameter.choices));
      }
      break;
    case Parameter::Type::kText:
      break;
  }
}

const char* toString(PluginKind kind) {
  switch (kind) {
    case PluginKind::kController:
      return "controller";
    case PluginKind::kSensor:
      return "sensor";
    case PluginKind::kActuator:
      return "actuator";
    case PluginKind::kEngine:
      return "engine";
    case PluginKind::kObserver:
      return "visualisation";
    case PluginKind::kEntity:
      return "entity";
    case PluginKind::kRule:
      return "rule";
  }
  return "plugin";
}

std::string describe(const Registry::Conflict& conflict) {
  const bool are_two = conflict.first_library != conflict.second_library;
  const bool names_implementation = !conflict.implementation.empty() && !conflict.is_about_default;
  return std::string(toString(conflict.kind)) + " '" + conflict.label +
         (names_implementation ? " " + conflict.implementation : "") +
         (conflict.is_about_default ? "' has two default implementations" : "' is registered twice") +
         (are_two ? " (" + conflict.first_library + ", " + conflict.second_library + ")" : "") + "; the first is used";
}

Registry& Registry::instance() {
  static Registry registry;
  return registry;
}

void Registry::add(PluginKind kind, PluginDescription description, Factory make) {
  for (const auto& entry : entries_) {
    if (entry->kind == kind && entry->description.label == description.label &&
        entry->description.implementation == description.implementation) {
      conflicts_.push_back({kind, description.label, description.implementation, libraryOf(&entry->make.target_type()),
                            libraryOf(&make.target_type()), false});
      return;
    }
  }
  const Entry* former = find(kind, description.label);
  if (description.is_default && former != nullptr && former->description.is_default) {
    conflicts_.push_back({kind, description.label, description.implementation, libraryOf(&former->make.target_type()),
                          libraryOf(&make.target_type()), true});
    description.is_default = false;
  }
  entries_.push_back(std::make_unique<Entry>(Entry{kind, std::move(description), std::move(make)}));
}

const Registry::Entry* Registry::find(PluginKind kind, const std::string& label,
                                      const std::string& implementation) const {
  const Entry* found = nullptr;
  for (const auto& entry : entries_) {
    const PluginDescription& known = entry->description;
    if (entry->kind != kind || (known.label != label && !contains(known.label_aliases, label))) {
      continue;
    }
    if (!implementation.empty()) {
      if (known.implementation == implementation || contains(known.implementation_aliases, implementation)) {
        return entry.get();
      }
    } else if (known.is_default) {
      return entry.get();
    } else if (found == nullptr || known.implementation < found->description.implementation) {
      found = entry.get();
    }
  }
  return found;
}

bool Registry::hasDefault(PluginKind kind, const std::string& label) const {
  const std::vector<const Entry*> entries = all(kind);
  const auto is_meant = [&](const Entry* entry) { return entry->description.label == label; };
  return std::count_if(entries.begin(), entries.end(), is_meant) == 1 ||
         std::any_of(entries.begin(), entries.end(),
                     [&](const Entry* entry) { return is_meant(entry) && entry->description.is_default; });
}

const Registry::Entry& Registry::require(PluginKind kind, const std::string& label) const {
  const Entry* entry = find(kind, label);
  if (entry == nullptr) {
    const std::vector<std::string> known = labels(kind);
    throw std::runtime_error(std::string(toString(kind)) + " '" + label +
                             "' is not registered; there are: " + joinNames(known) + didYouMean(label, known));
  }
  return *entry;
}

std::vector<const Registry::Entry*> Registry::all(PluginKind kind) const {
  std::vector<const Entry*> result;
  for (const auto& entry : entries_) {
    if (entry->kind == kind) {
      result.push_back(entry.get());
    }
  }
  std::sort(result.begin(), result.end(), [](const Entry* a, const Entry* b) {
    return std::tie(a->description.label, a->description.implementation) <
           std::tie(b->description.label, b->description.implementation);
  });
  return result;
}

std::vector<std::string> Registry::labels(PluginKind kind) const {
  std::vector<std::string> result;
  for (const Entry* entry : all(kind)) {
    if (!contains(result, entry->description.label)) {
      result.push_back(entry->description.label);
    }
  }
  return result;
}

}  // namespace swarmanoid
