#include "fault_form.hpp"

#include <algorithm>

#include "../reader/reader.hpp"
#include "swarmanoid_space/error_models/complete_error.hpp"

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
      const Parameter* parameter = findErrorParameter(error.kind, value.name());
      if (parameter == nullptr || value.text() != parameter->value) {
        text.attribute(value.name(), value.text());
      }
    }
    text.end();
  }
}

}  // namespace swarmanoid
