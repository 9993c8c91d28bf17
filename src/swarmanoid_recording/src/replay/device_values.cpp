#include "device_values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/number_type.hpp"

namespace swarmanoid::replay {
namespace {

template <class Number>
Field numberField(ByteReader& in) {
  const auto value = in.number<Number>();
  Field field;
  if constexpr (std::is_same_v<Number, bool>) {
    field.number = value ? "true" : "false";
  } else {
    char text[64];
    const auto [end, error] = std::to_chars(text, text + sizeof text, value);
    field.number.assign(text, end);
    if constexpr (std::is_floating_point_v<Number>) {
      field.is_finite = std::isfinite(value);
    }
  }
  return field;
}

Field readNumber(const std::string& type, ByteReader& in) {
  const std::optional<NumberType> found = findNumberType(type);
  if (!found) {
    throw ByteError("found the field '" + type + "', which is none that is known here");
  }
  return withNumberType(*found, [&](auto number) { return numberField<decltype(number)>(in); });
}

/// Returns the position after the bracket that closes the one at `open`.
std::size_t afterBracket(const std::string& layout, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < layout.size(); ++i) {
    depth += layout[i] == '(' ? 1 : layout[i] == ')' ? -1 : 0;
    if (depth == 0) {
      return i + 1;
    }
  }
  throw ByteError("found the fields '" + layout + "' with a bracket that is not closed");
}

std::vector<Field> readFields(const std::string& layout, ByteReader& in) {
  std::vector<Field> fields;
  for (std::size_t i = 0; i < layout.size();) {
    if (layout[i] == ' ') {
      ++i;
    } else if (layout[i] == '(') {
      const std::size_t end = afterBracket(layout, i);
      const std::string inner = layout.substr(i + 1, end - i - 2);
      Field field;
      field.is_variable = true;
      const auto count = in.number<std::uint32_t>();
      for (std::uint32_t k = 0; k < count; ++k) {
        field.elements.push_back(readFields(inner, in));
      }
      fields.push_back(std::move(field));
      i = end + 1;  // skips the star as well
    } else {
      const std::size_t end = std::min(layout.find(' ', i), layout.size());
      fields.push_back(readNumber(layout.substr(i, end - i), in));
      i = end;
    }
  }
  return fields;
}

using Values = std::vector<std::pair<std::string, std::string>>;

/// @param numbers of the device; null if they are unknown
void addNamed(const std::vector<Field>& fields, const std::vector<DeviceNumber>* numbers, const std::string& prefix,
              Values& out) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string name = prefix + (numbers != nullptr ? (*numbers)[i].name : std::to_string(i));
    if (!fields[i].is_variable) {
      out.emplace_back(name, fields[i].number);
    }
    const std::vector<DeviceNumber>* inner = numbers != nullptr ? &(*numbers)[i].elements : nullptr;
    for (std::size_t k = 0; k < fields[i].elements.size(); ++k) {
      addNamed(fields[i].elements[k], inner, name + "[" + std::to_string(k) + "].", out);
    }
  }
}

}  // namespace

std::vector<Field> decode(const std::string& layout, Span<const std::uint8_t> bytes) {
  ByteReader in(bytes);
  std::vector<Field> fields = readFields(layout, in);
  if (in.left() > 0) {
    throw ByteError("found " + std::to_string(in.left()) + " bytes more than the fields '" + layout + "' have");
  }
  return fields;
}

std::string toText(const std::vector<Field>& fields) {
  std::string text;
  for (const Field& field : fields) {
    text += text.empty() ? "" : " ";
    if (!field.is_variable) {
      text += field.number;
      continue;
    }
    std::string elements;
    for (const auto& element : field.elements) {
      elements += (elements.empty() ? "(" : " (") + toText(element) + ")";
    }
    text += "[" + elements + "]";
  }
  return text;
}

Values named(const std::vector<Field>& fields, const DeviceLayout& device) {
  const DeviceType* type = findDeviceType(device.type);
  Values result;
  addNamed(fields, type != nullptr && type->layout == device.layout ? &type->numbers : nullptr, "", result);
  return result;
}

bool isFinite(const std::vector<Field>& fields) {
  return std::all_of(fields.begin(), fields.end(), [](const Field& field) {
    return field.is_finite && std::all_of(field.elements.begin(), field.elements.end(), isFinite);
  });
}

}  // namespace swarmanoid::replay
