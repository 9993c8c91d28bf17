#include "agent_fields.hpp"

#include <cmath>
#include <cstring>
#include <limits>
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

template <class Number>
Number converted(float number) {
  if constexpr (std::is_same_v<Number, bool>) {
    return number != 0.0F;
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
    const FieldTable& table = fieldTableOf(*device);
    const std::string rest = name.size() > type.size() ? name.substr(type.size() + 1) : "";
    const FieldPlaces* field = table.findField(rest);
    if (field == nullptr) {
      std::vector<std::string> known;
      for (const FieldPlaces& each : table.fields) {
        known.push_back(type + "." + each.name);
      }
      throw ConfigError(location, unknownName("the field", name, known));
    }
    parts_.push_back({device, field});
    size_ += field->offsets.size();
  }
}

void AgentFields::refuse(const DeviceType& device) const {
  throw ConfigError({option_, 0}, "found the device '" + device.type +
                                      "', which the controller does not list, allowed: its own devices");
}

void AgentFields::gather(const std::vector<const std::byte*>& devices, float* numbers) const {
  for (std::size_t k = 0; k < parts_.size(); ++k) {
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

void AgentFields::scatter(const float* numbers, const std::vector<std::byte*>& devices) const {
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

}  // namespace swarmanoid
