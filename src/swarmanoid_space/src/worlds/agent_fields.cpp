#include "agent_fields.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>
#include <type_traits>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/number_type.hpp"

namespace swarmanoid {
namespace {

std::vector<std::string> typesOf(DeviceKind kind) {
  std::vector<std::string> types;
  for (const DeviceType* device : deviceTypes()) {
    if (device->kind == kind) {
      types.push_back(device->type);
    }
  }
  return types;
}

template <class Number, class Given>
Number converted(Given number) {
  if constexpr (std::is_same_v<Number, bool>) {
    return number != Given{0};
  } else if constexpr (std::is_integral_v<Number>) {
    const double whole = std::nearbyint(static_cast<double>(number));
    if (!(whole > static_cast<double>(std::numeric_limits<Number>::min()))) {
      return std::isnan(whole) ? Number{0} : std::numeric_limits<Number>::min();
    }
    return whole < static_cast<double>(std::numeric_limits<Number>::max()) ? static_cast<Number>(whole)
                                                                           : std::numeric_limits<Number>::max();
  } else {
    return static_cast<Number>(number);
  }
}

/// Names of the fields of a device, and of its lists, behind "device.".
std::vector<std::string> namesIn(const DeviceType& device) {
  const FieldTable& table = fieldTableOf(device);
  std::vector<std::string> names;
  for (const FieldPlaces& field : table.fields) {
    names.push_back(device.type + "." + field.name);
  }
  for (const ListPlaces& list : table.lists) {
    for (const FieldPlaces& field : list.elements.fields) {
      names.push_back(device.type + "." + list.name + "." + field.name);
    }
  }
  return names;
}

/// The attributes in the brackets behind a name: "near sectors=8". @param attributes without brackets
Configuration attributesOf(const std::string& name, const std::string& attributes, const std::string& option) {
  Configuration read(name, "", {option, 0});
  std::istringstream words(attributes);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    read.set(word.substr(0, equals), equals == std::string::npos ? "true" : word.substr(equals + 1));
  }
  return read;
}

constexpr double kMost = 1000.0;  // elements or sectors of a field

/// The attributes that elements and sectors have in common.
ListSectors::Options optionsOf(const Configuration& attributes, const FieldDescription& field) {
  const Range bounds = scalingBoundsOf(field);
  ListSectors::Options options;
  options.range.minimum = attributes.number("minimum", bounds.minimum, bounds);
  options.range.maximum = attributes.number("maximum", bounds.maximum, bounds);
  options.is_near = attributes.boolean("near", false);
  if (!std::isfinite(options.range.minimum) || !std::isfinite(options.range.maximum) ||
      options.range.minimum >= options.range.maximum) {
    throw ConfigError(attributes.location(), attributes.name() + ": found values " + options.range.toString() +
                                                 ", allowed: with minimum and maximum, minimum < maximum");
  }
  return options;
}

}  // namespace

AgentFields::AgentFields(const std::vector<std::string>& names, DeviceKind kind, const std::string& option)
    : option_(option) {
  const SourceLocation location{option, 0};
  if (names.empty()) {
    throw ConfigError(location, "found no fields, allowed: one or more, each as device.field");
  }
  for (const std::string& name : names) {
    const std::string type = name.substr(0, name.find('.'));
    const DeviceType* device = findDeviceType(type);
    if (device == nullptr || device->kind != kind) {
      throw ConfigError(location, unknownName("the device", type, typesOf(kind)));
    }
    parts_.push_back(partOf(*device, name.size() > type.size() ? name.substr(type.size() + 1) : ""));
    size_ += parts_.back().size();
  }
}

AgentFields::Part AgentFields::partOf(const DeviceType& device, const std::string& rest) const {
  const FieldTable& table = fieldTableOf(device);
  if (const FieldPlaces* field = table.findField(rest)) {
    return {&device, field, std::nullopt, std::nullopt};
  }
  const std::size_t bracket = std::min(rest.find('['), rest.size());
  const std::string path = rest.substr(0, bracket);
  const std::string name = device.type + "." + path;
  const ListPlaces* list = table.findList(path.substr(0, path.find('.')));
  const FieldPlaces* field = list == nullptr || path.size() <= list->name.size()
                                 ? nullptr
                                 : list->elements.findField(path.substr(list->name.size() + 1));
  const SourceLocation location{option_, 0};
  if (field == nullptr) {
    throw ConfigError(location, unknownName("the field", name, namesIn(device)));
  }
  if (device.kind != DeviceKind::kSensor || bracket == rest.size() || rest.back() != ']') {
    throw ConfigError(location, "found '" + device.type + "." + rest + "', which is in a list, allowed: " +
                                    (device.kind == DeviceKind::kSensor ? name + "[sectors=8]" : "no fields of lists"));
  }
  const Configuration attributes = attributesOf(name, rest.substr(bracket + 1, rest.size() - bracket - 2), option_);
  ListSectors::Options options = optionsOf(attributes, device.fields[field->description]);
  if (attributes.has("sectors") == attributes.has("count")) {
    throw ConfigError(location, name + ": found a field of a list, allowed: with either count or sectors");
  }
  if (attributes.has("count")) {
    const auto count = static_cast<std::size_t>(attributes.integer("count", {1.0, kMost}));
    attributes.refuseUnread({"count", "minimum", "maximum", "near"});
    return {&device, nullptr, FirstElements(*list, *field, count, options.range, options.is_near), std::nullopt};
  }
  options.sectors = static_cast<std::size_t>(attributes.integer("sectors", {2.0, kMost}));
  options.colors = colorsIn(attributes, "colors");
  attributes.refuseUnread({"sectors", "minimum", "maximum", "near", "colors"});
  const std::string reason = ListSectors::reasonAgainst(device, *list, *field, !options.colors.empty());
  if (!reason.empty()) {
    throw ConfigError(location, name + ": found sectors, allowed: " + reason);
  }
  return {&device, nullptr, std::nullopt, ListSectors(device, *list, *field, options)};
}

std::vector<std::vector<Range>> AgentFields::bounds() const {
  std::vector<std::vector<Range>> bounds;
  for (const Part& part : parts_) {
    const Range range = part.field != nullptr ? part.device->fields[part.field->description].range
                        : part.first          ? part.first->bounds()
                                              : part.sectors->bounds();
    bounds.emplace_back(part.size(), range);
  }
  return bounds;
}

void AgentFields::refuse(const DeviceType& device) const {
  throw ConfigError({option_, 0}, "found the device '" + device.type +
                                      "', which the controller does not list, allowed: its own devices");
}

void AgentFields::gather(const std::vector<const std::byte*>& devices, float* numbers) const {
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    if (parts_[k].sectors) {
      parts_[k].sectors->read(devices[k], numbers);
      numbers += parts_[k].size();
      continue;
    }
    if (parts_[k].first) {
      parts_[k].first->read(devices[k], numbers);
      numbers += parts_[k].size();
      continue;
    }
    const FieldPlaces& field = *parts_[k].field;
    if (field.type == NumberType::kF4) {
      for (const FieldPlaces::Piece& piece : field.pieces) {
        std::memcpy(numbers, devices[k] + piece.offset, piece.size);
        numbers += piece.size / sizeof(float);
      }
      continue;
    }
    withNumberType(field.type, [&](auto number) {
      for (const std::size_t offset : field.offsets) {
        std::memcpy(&number, devices[k] + offset, sizeof(number));
        *numbers++ = static_cast<float>(number);
      }
    });
  }
}

template <class Number>
void AgentFields::write(const Number* numbers, const std::vector<std::byte*>& devices) const {
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const FieldPlaces& field = *parts_[k].field;
    withNumberType(field.type, [&](auto number) {
      for (const std::size_t offset : field.offsets) {
        number = converted<decltype(number)>(*numbers++);
        std::memcpy(devices[k] + offset, &number, sizeof(number));
      }
    });
  }
}

void AgentFields::scatter(const float* numbers, const std::vector<std::byte*>& devices) const {
  write(numbers, devices);
}

void AgentFields::scatter(const double* numbers, const std::vector<std::byte*>& devices) const {
  write(numbers, devices);
}

}  // namespace swarmanoid
