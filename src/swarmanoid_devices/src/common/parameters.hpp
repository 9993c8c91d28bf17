/// Short functions for the parameters that many devices have.
#pragma once

#include <string>

#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid::devices {

inline Parameter number(const std::string& name, const std::string& unit, const std::string& value, Range range,
                        const std::string& description) {
  return makeParameter(name, Parameter::Type::kNumber, unit, value, range, description);
}

inline Parameter angle(const std::string& name, const std::string& value, Range range, const std::string& description) {
  return makeParameter(name, Parameter::Type::kAngle, "deg", value, range, description);
}

inline Parameter integer(const std::string& name, const std::string& value, Range range,
                         const std::string& description) {
  return makeParameter(name, Parameter::Type::kInteger, "", value, range, description);
}

inline Parameter boolean(const std::string& name, const std::string& value, const std::string& description) {
  return makeParameter(name, Parameter::Type::kBoolean, "", value, {}, description);
}

}  // namespace swarmanoid::devices
