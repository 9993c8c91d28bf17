#include "port.hpp"

#include <cmath>

#include "swarmanoid_interface/contains.hpp"
#include "swarmanoid_interface/list_sectors.hpp"

namespace swarmanoid::neural {
namespace {

/// "joints.angle" for "joints[].angle": tags contain no brackets.
std::string tagsOf(const FieldDescription& field) {
  std::string name = field.name;
  for (std::size_t at = name.find("[]"); at != std::string::npos; at = name.find("[]")) {
    name.erase(at, 2);
  }
  return name;
}

void refuseText(const Configuration& element) {
  if (!element.text().empty()) {
    throw ConfigError(element.location(),
                      "found the text '" + element.text() + "' in <" + element.name() + ">, allowed: none");
  }
}

void takePlaces(Port& port, const std::vector<DeviceNumber>& numbers, std::size_t field, const DeviceNumber* span) {
  for (const DeviceNumber& number : numbers) {
    if (number.kind == DeviceNumber::Kind::kSpan) {
      takePlaces(port, number.elements, field, &number);
    } else if (number.field == field) {
      if (number.kind == DeviceNumber::Kind::kEnumeration) {
        refuse(port, " (one of several modes)", "numbers and truth values");
      }
      port.places.push_back(placeOf(number, *port.field));
      port.span = span;
    }
  }
}

Port portOf(const DeviceType& type, std::size_t field, const Configuration& parameters) {
  Port port{&type, &type.fields[field], {}, nullptr, {}, &parameters};
  refuseText(parameters);
  takePlaces(port, type.numbers, field, nullptr);
  return port;
}

/// Adds the fields that an element and its children name.
/// @param prefix of the fields' names, with its dot
void collect(const DeviceType& type, const Configuration& element, const std::string& prefix,
             std::vector<Port>& ports) {
  refuseText(element);
  const std::size_t before = ports.size();
  std::vector<std::string> known;
  for (std::size_t i = 0; i < type.fields.size(); ++i) {
    const std::string name = tagsOf(type.fields[i]);
    if (name.compare(0, prefix.size(), prefix) != 0) {
      continue;
    }
    const std::string rest = name.substr(prefix.size());
    const std::string tag = rest.substr(0, rest.find('.'));
    if (contains(known, tag)) {
      continue;
    }
    known.push_back(tag);
    if (const Configuration* inner = element.find(tag)) {
      if (tag == rest) {
        ports.push_back(portOf(type, i, *inner));
      } else {
        collect(type, *inner, prefix + tag + ".", ports);
      }
    }
  }
  element.refuseUnread(known);
  if (ports.size() == before) {
    throw ConfigError(element.location(),
                      "found <" + element.name() + "> without a field, allowed: " + joinNames(known));
  }
}

}  // namespace

std::vector<Port> portsOf(const Robot& robot, const Configuration& element, DeviceKind kind) {
  refuseText(element);
  std::vector<Port> ports;
  std::vector<std::string> known;
  for (const DeviceType* type : deviceTypes()) {
    const bool is_listed = kind == DeviceKind::kSensor ? robot.hasSensor(type->type) : robot.hasActuator(type->type);
    if (type->kind != kind || !is_listed) {
      continue;
    }
    known.push_back(type->type);
    if (const Configuration* device = element.find(type->type)) {
      collect(*type, *device, "", ports);
    }
  }
  element.refuseUnread(known);
  if (ports.empty()) {
    throw ConfigError(element.location(),
                      "found <" + element.name() + "> without a device, allowed: " +
                          (known.empty() ? "none, since the controller lists none" : joinNames(known)));
  }
  return ports;
}

void takeRange(Port& port) {
  const Range bounds = scalingBoundsOf(*port.field);
  port.range.minimum = port.parameters->number("minimum", bounds.minimum, bounds);
  port.range.maximum = port.parameters->number("maximum", bounds.maximum, bounds);
  if (!std::isfinite(port.range.minimum) || !std::isfinite(port.range.maximum)) {
    refuse(port, ", whose values are " + bounds.toString(), "with minimum and maximum");
  }
  if (port.range.minimum >= port.range.maximum) {
    refuse(port, " " + port.range.toString(), "minimum < maximum");
  }
}

void takeCount(Port& port) {
  const auto size = static_cast<std::int64_t>(port.places.size());
  port.places.resize(
      static_cast<std::size_t>(port.parameters->integer("count", size, {1.0, static_cast<double>(size)})));
}

void refuse(const Port& port, const std::string& found, const std::string& allowed) {
  throw ConfigError(port.parameters->location(), "found the field '" + tagsOf(*port.field) + "' of " + port.type->type +
                                                     found + ", allowed: " + allowed);
}

}  // namespace swarmanoid::neural
