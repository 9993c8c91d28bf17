#include "parameter_text.hpp"

#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::program {
namespace {

/// Returns "two numbers, each from 0 to 1".
std::string several(const std::string& numbers, const Range& range) {
  const std::string bounds = range.toString();
  return bounds == Range().toString() ? numbers : numbers + ", each " + bounds;
}

}  // namespace

std::string allowedValues(const Parameter& parameter) {
  switch (parameter.type) {
    case Parameter::Type::kChoice:
      return "one of " + joinNames(parameter.choices);
    case Parameter::Type::kNumber:
    case Parameter::Type::kInteger:
    case Parameter::Type::kAngle:
      return parameter.range.toString();
    case Parameter::Type::kBoolean:
      return "true, false";
    case Parameter::Type::kColor:
      return "a colour";
    case Parameter::Type::kVector2:
      return several("two numbers", parameter.range);
    case Parameter::Type::kVector3:
    case Parameter::Type::kAngles3:
      return several("three numbers", parameter.range);
    case Parameter::Type::kText:
      return "text";
  }
  return "";
}

}  // namespace swarmanoid::program
