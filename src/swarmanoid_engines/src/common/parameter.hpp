/// A short way to write the parameters of engines.
#pragma once

#include <sstream>
#include <string>

#include "swarmanoid_interface/plain_text.hpp"
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

/// One whose default is the value that the engine's settings start with.
inline Parameter makeNumber(const std::string& name, const std::string& unit, double value, Range range,
                            const std::string& description) {
  PlainTextStream text;
  text << value;
  return makeParameter(name, Parameter::Type::kNumber, unit, text.str(), description, range);
}

/// One that may change while an experiment runs. @see Engine::reconfigure
inline Parameter live(Parameter parameter) {
  parameter.is_live = true;
  return parameter;
}

}  // namespace swarmanoid
