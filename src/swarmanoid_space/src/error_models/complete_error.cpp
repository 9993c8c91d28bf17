#include "swarmanoid_space/error_models/complete_error.hpp"

#include <algorithm>

#include "swarmanoid_space/models/limits.hpp"

namespace swarmanoid {
namespace {

/// @throws ConfigError for a parameter that the kind does not have, or that is given twice
void refuseStrangeParameters(const ErrorModelDescription& error, const ErrorKind& kind) {
  const std::vector<Parameter>& known = kind.description.parameters;
  for (const Configuration& given : error.parameters.children()) {
    const auto is_same = [&](const auto& other) { return other.name() == given.name(); };
    const auto is_meant = [&](const Parameter& parameter) { return parameter.name == given.name(); };
    if (std::none_of(known.begin(), known.end(), is_meant)) {
      throw ConfigError(given.location(),
                        unknownName("attribute", given.name(), attributesOfKind(kind)) + " (in <error>)");
    }
    const std::vector<Configuration>& all = error.parameters.children();
    if (std::count_if(all.begin(), all.end(), is_same) > 1) {
      throw ConfigError(given.location(), "found '" + given.name() + "' twice in <error>, allowed: once");
    }
  }
}

/// Returns the parameters of `error` with defaults for the others. @throws ConfigError
Configuration completeParameters(const ErrorModelDescription& error, const ErrorKind& kind) {
  Configuration result("error", "", error.location);
  refuseStrangeParameters(error, kind);
  for (const Parameter& parameter : kind.description.parameters) {
    const Configuration* given = error.parameters.find(parameter.name);
    if (given == nullptr && !parameter.value) {
      throw ConfigError(error.location, "<error> of the kind '" + kind.description.name + "' needs the attribute " +
                                            parameter.name + "=\"...\"");
    }
    const SourceLocation location = given != nullptr ? given->location() : error.location;
    const std::string text = given != nullptr ? given->text() : parameter.value.value_or("");
    checkValue(parameter, text, location);
    result.add(Configuration(parameter.name, text, location));
  }
  return result;
}

}  // namespace

void completeError(ErrorModelDescription& error) {
  const ErrorKind* kind = findErrorKind(error.kind);
  if (kind == nullptr) {
    throw ConfigError(error.location, unknownName("the error kind", error.kind, errorKindNames()));
  }
  if (static_cast<double>(error.from_tick) > limits::kTick.maximum) {
    parseInteger(std::to_string(error.from_tick), "from_tick", error.location, limits::kTick);  // throws
  }
  error.parameters = completeParameters(error, *kind);
}

std::vector<std::string> attributesOfKind(const ErrorKind& kind) {
  std::vector<std::string> names{"kind", "id", "field", "from_tick"};
  for (const Parameter& parameter : kind.description.parameters) {
    names.push_back(parameter.name);
  }
  return names;
}

const Parameter* findErrorParameter(const std::string& kind, const std::string& name) {
  if (const ErrorKind* found = findErrorKind(kind)) {
    for (const Parameter& parameter : found->description.parameters) {
      if (parameter.name == name) {
        return &parameter;
      }
    }
  }
  return nullptr;
}

}  // namespace swarmanoid
