#include "swarmanoid_interface/device_field.hpp"

namespace swarmanoid {

std::string typeName(const FieldDescription& field) {
  const std::string bits = std::to_string(8 * std::stoi(field.type.substr(1)));
  switch (field.type[0]) {
    case 'b':
      return "bool";
    case 'f':
      return "float" + bits;
    case 'u':
      return "uint" + bits;
    default:
      return "int" + bits;
  }
}

std::string countedName(const FieldDescription& field) {
  std::string name = field.name;
  std::size_t bracket = name.find("[]");
  std::size_t count = field.count;
  if (count == 0 && bracket != std::string::npos) {
    bracket = name.find("[]", bracket + 1);  // the first one is that of the span
    count = field.count_in_element;
  }
  if (bracket != std::string::npos && count > 0) {
    name.insert(bracket + 1, std::to_string(count));
  }
  return name;
}

std::string describe(const FieldDescription& field) {
  const bool is_bounded = field.range.minimum != -kInfinity || field.range.maximum != kInfinity;
  return countedName(field) + (field.unit.empty() ? "" : " [" + field.unit + "]") + ", " + typeName(field) +
         (is_bounded ? ", " + field.range.toString() : "");
}

}  // namespace swarmanoid
