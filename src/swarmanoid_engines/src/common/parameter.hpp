/// Short forms for the parameters of engines. @see makeParameter
#pragma once

#include <sstream>
#include <string>

#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

/// A number whose default is the initial value in the engine's settings.
inline Parameter makeNumber(const std::string& name, const std::string& unit, double value, Range range,
                            const std::string& description) {
  PlainTextStream text;
  text << value;
  return makeParameter(name, Parameter::Type::kNumber, unit, text.str(), range, description);
}

/// A parameter that may change while an experiment runs. @see Engine::reconfigure
inline Parameter live(Parameter parameter) {
  parameter.is_live = true;
  return parameter;
}

}  // namespace swarmanoid
