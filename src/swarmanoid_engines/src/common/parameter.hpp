/// A short way to write the parameters of engines.
#pragma once

#include <string>

#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

inline Parameter makeParameter(const std::string& name, Parameter::Type type, const std::string& unit,
                               const std::string& value, const std::string& description, Range range = {}) {
  Parameter result;
  result.name = name;
  result.type = type;
  result.unit = unit;
  result.value = value;
  result.description = description;
  result.range = range;
  return result;
}

}  // namespace swarmanoid
