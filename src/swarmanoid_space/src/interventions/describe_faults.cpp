#include "describe_faults.hpp"

#include "swarmanoid_space/error_models/complete_error.hpp"

namespace swarmanoid {
namespace {

/// Returns a text that is the same for equal values.
std::string valueText(const Configuration& value, const Parameter* parameter) {
  const bool is_number = parameter != nullptr &&
                         (parameter->type == Parameter::Type::kNumber || parameter->type == Parameter::Type::kInteger ||
                          parameter->type == Parameter::Type::kAngle);
  return is_number ? numberText(parseNumber(value.text(), value.name(), value.location())) : value.text();
}

/// Returns "gaussian (deviation 0.02) on value from tick 300".
std::string describeFault(const ErrorModelDescription& error) {
  std::string values;
  for (const Configuration& value : error.parameters.children()) {
    values += (values.empty() ? " (" : ", ") + value.name() + " " +
              valueText(value, findErrorParameter(error.kind, value.name()));
  }
  return error.kind + (values.empty() ? "" : values + ")") + (error.field.empty() ? "" : " on " + error.field) +
         (error.from_tick == 0 ? "" : " from tick " + std::to_string(error.from_tick));
}

}  // namespace

std::string describeFaults(const std::vector<ErrorModelDescription>& errors) {
  std::string text;
  for (const ErrorModelDescription& error : errors) {
    text += (text.empty() ? "" : ", ") + describeFault(error);
  }
  return text.empty() ? "mended" : text;
}

}  // namespace swarmanoid
