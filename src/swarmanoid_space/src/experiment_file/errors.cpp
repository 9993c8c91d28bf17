// <error> in a sensor or an actuator.
#include <algorithm>

#include "reader.hpp"
#include "swarmanoid_space/error_models/device_errors.hpp"

namespace swarmanoid::experiment {
namespace {

/// Reads the kind's own parameters, which are attributes, as far as they are given.
Configuration readErrorParameters(const XmlElement& element, const ErrorKind& kind) {
  Configuration parameters("error", "", element.location());
  for (const Parameter& parameter : kind.description.parameters) {
    if (const auto text = element.attribute(parameter.name.c_str())) {
      parameters.add(Configuration(parameter.name, *text, element.attributeLocation(parameter.name.c_str())));
    }
  }
  return parameters;
}

std::vector<std::string> attributesOfKind(const ErrorKind& kind) {
  std::vector<std::string> names{"kind", "id", "field", "from_tick"};
  for (const Parameter& parameter : kind.description.parameters) {
    names.push_back(parameter.name);
  }
  return names;
}

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

ErrorModelDescription readError(const XmlElement& element) {
  if (const std::vector<XmlElement> children = element.children(); !children.empty()) {
    children.front().refuse("found <" + children.front().name() + "> in <error>, allowed: only attributes");
  }
  if (!element.text().empty()) {
    element.refuse("found the text '" + element.text() + "' in <error>, allowed: only attributes");
  }
  ErrorModelDescription error;
  error.location = element.location();
  error.field_location = element.attributeLocation("field");
  error.kind = element.requireAttribute("kind");
  const ErrorKind* kind = findErrorKind(error.kind);
  if (kind == nullptr) {
    throw ConfigError(element.attributeLocation("kind"), unknownName("the error kind", error.kind, errorKindNames()));
  }
  element.allowAttributes(attributesOfKind(*kind));
  error.field = element.attribute("field").value_or("");
  if (const auto text = element.attribute("from_tick")) {
    const SourceLocation location = element.attributeLocation("from_tick");
    error.from_tick = static_cast<std::uint64_t>(parseInteger(*text, "from_tick", location, kTickRange));
  }
  error.parameters = readErrorParameters(element, *kind);
  completeError(error);
  return error;
}

}  // namespace

void completeError(ErrorModelDescription& error) {
  const ErrorKind* kind = findErrorKind(error.kind);
  if (kind == nullptr) {
    throw ConfigError(error.location, unknownName("the error kind", error.kind, errorKindNames()));
  }
  if (static_cast<double>(error.from_tick) > kTickRange.maximum) {
    parseInteger(std::to_string(error.from_tick), "from_tick", error.location, kTickRange);  // throws
  }
  error.parameters = completeParameters(error, *kind);
}

std::vector<ErrorModelDescription> readErrors(const XmlElement& element, const std::string& device) {
  std::vector<ErrorModelDescription> errors;
  TakenIds ids;
  for (const XmlElement& child : element.children()) {
    if (child.name() != "error") {
      continue;
    }
    errors.push_back(readError(child));
    if (const auto id = child.attribute("id")) {
      takeId("error", *id, child, ids);
    }
    if (!device.empty()) {
      DeviceErrors(device.c_str()).add({errors.back()});  // throws if the error does not suit the device
    }
  }
  return errors;
}

}  // namespace swarmanoid::experiment
