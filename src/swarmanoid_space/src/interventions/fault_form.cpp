#include "fault_form.hpp"

#include <algorithm>

#include "../experiment_file/reader.hpp"
#include "swarmanoid_space/error_models/error_model.hpp"

namespace swarmanoid {
namespace {

/// Reads the attribute `device` of <fault>; refuses a device that no controller has.
std::string requireDevice(const experiment::XmlElement& element, const Experiment& experiment) {
  std::string device = element.requireAttribute("device");
  std::vector<std::string> known;
  for (const ControllerDescription& controller : experiment.controllers) {
    for (const std::vector<DeviceDescription>* devices : {&controller.sensors, &controller.actuators}) {
      for (const DeviceDescription& use : *devices) {
        if (std::find(known.begin(), known.end(), use.type) == known.end()) {
          known.push_back(use.type);
        }
      }
    }
  }
  if (std::find(known.begin(), known.end(), device) == known.end()) {
    throw ConfigError(element.attributeLocation("device"), unknownName("the device", device, known));
  }
  return device;
}

/// @return null if there is none
const Parameter* findParameter(const std::string& kind, const std::string& name) {
  if (const ErrorKind* found = findErrorKind(kind)) {
    for (const Parameter& parameter : found->description.parameters) {
      if (parameter.name == name) {
        return &parameter;
      }
    }
  }
  return nullptr;
}

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
    values +=
        (values.empty() ? " (" : ", ") + value.name() + " " + valueText(value, findParameter(error.kind, value.name()));
  }
  return error.kind + (values.empty() ? "" : values + ")") + (error.field.empty() ? "" : " on " + error.field) +
         (error.from_tick == 0 ? "" : " from tick " + std::to_string(error.from_tick));
}

}  // namespace

SetFault readFault(const experiment::XmlElement& element, const Experiment& experiment) {
  element.allowChildren({"error"});
  SetFault result{element.requireAttribute("robot"), requireDevice(element, experiment), {}};
  result.errors = experiment::readErrors(element, result.device);
  return result;
}

void writeFault(const SetFault& what, ElementText& text) {
  text.attribute("robot", what.robot);
  text.attribute("device", what.device);
  for (const ErrorModelDescription& error : what.errors) {
    text.begin("error");
    text.attribute("kind", error.kind);
    if (!error.field.empty()) {
      text.attribute("field", error.field);
    }
    if (error.from_tick > 0) {
      text.attribute("from_tick", std::to_string(error.from_tick));
    }
    for (const Configuration& value : error.parameters.children()) {
      const Parameter* parameter = findParameter(error.kind, value.name());
      if (parameter == nullptr || value.text() != parameter->value) {
        text.attribute(value.name(), value.text());
      }
    }
    text.end();
  }
}

std::string describeFaults(const std::vector<ErrorModelDescription>& errors) {
  std::string text;
  for (const ErrorModelDescription& error : errors) {
    text += (text.empty() ? "" : ", ") + describeFault(error);
  }
  return text.empty() ? "mended" : text;
}

}  // namespace swarmanoid
