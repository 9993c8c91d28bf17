/// Short ways to write the parameters that many devices have.
#pragma once

#include <string>

#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid::devices {

inline Parameter number(const std::string& name, const std::string& unit, const std::string& value, Range range,
                        const std::string& description) {
  Parameter parameter;
  parameter.name = name;
  parameter.type = Parameter::Type::kNumber;
  parameter.unit = unit;
  parameter.value = value;
  parameter.range = range;
  parameter.description = description;
  return parameter;
}

inline Parameter angle(const std::string& name, const std::string& value, Range range, const std::string& description) {
  Parameter parameter = number(name, "deg", value, range, description);
  parameter.type = Parameter::Type::kAngle;
  return parameter;
}

inline Parameter integer(const std::string& name, const std::string& value, Range range,
                         const std::string& description) {
  Parameter parameter = number(name, "", value, range, description);
  parameter.type = Parameter::Type::kInteger;
  return parameter;
}

inline Parameter boolean(const std::string& name, const std::string& value, const std::string& description) {
  Parameter parameter;
  parameter.name = name;
  parameter.type = Parameter::Type::kBoolean;
  parameter.value = value;
  parameter.description = description;
  return parameter;
}

}  // namespace swarmanoid::devices
