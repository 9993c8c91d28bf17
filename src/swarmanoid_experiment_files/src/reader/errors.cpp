// <error> in a sensor or an actuator.
#include <algorithm>

#include "reader.hpp"
#include "swarmanoid_space/error_models/complete_error.hpp"
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
    error.from_tick = static_cast<std::uint64_t>(parseInteger(*text, "from_tick", location, limits::kTick));
  }
  error.parameters = readErrorParameters(element, *kind);
  completeError(error);
  return error;
}

}  // namespace

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
