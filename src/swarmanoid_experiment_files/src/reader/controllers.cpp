// <controllers>: the controllers of the experiment, with their devices.
#include <algorithm>
#include <filesystem>

#include "reader.hpp"

namespace swarmanoid::experiment {
namespace {

/// Replaces one of the two spellings of the thesis's sample controller.
std::string withoutAlias(const std::string& name) {
  return name == "footbot_sample_controller" ? "sample_footbot_controller" : name;
}

std::vector<std::string> implementationsOf(PluginKind kind, const std::string& type) {
  std::vector<std::string> names;
  for (const Registry::Entry* entry : Registry::instance().all(kind)) {
    if (entry->description.label == type) {
      names.push_back(entry->description.implementation);
    }
  }
  return names;
}

/// Refuses a device parameter named `error`: the tag <error> belongs to the framework.
void refuseErrorParameter(const XmlElement& element, const PluginDescription& device) {
  for (const Parameter& parameter : device.parameters) {
    if (parameter.name == "error") {
      element.refuse("found the parameter 'error' of the implementation '" + device.implementation +
                     "', allowed: another name, since <error> in a device is an error model");
    }
  }
}

/// Adds the file that a device's parameter `file` names to the experiment's files, as for the floor; the device gets
/// its path.
void takeFileOf(const XmlElement& element, Configuration& parameters, Reader& reader) {
  const auto child = element.child("file");
  if (!child || !parameters.has("file")) {
    return;
  }
  const std::string path = takeFile(child->text(), reader);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    child->refuse("file: found '" + child->text() + "', which is no file, allowed: the name of a file that is there");
  }
  Configuration with_path(parameters.name(), parameters.text(), parameters.location());
  for (const Configuration& value : parameters.children()) {
    with_path.add(value.name() == "file" ? Configuration("file", path, value.location()) : value);
  }
  parameters = std::move(with_path);
}

DeviceDescription readDevice(PluginKind kind, const XmlElement& element, Reader& reader) {
  const std::string path = kind == PluginKind::kSensor ? "controllers/*/sensors/*" : "controllers/*/actuators/*";
  element.allowAttributes(attributesOf(path));
  DeviceDescription device;
  device.library = element.attribute("library").value_or("");
  device.location = element.location();
  const Registry::Entry* entry = &reader.requirePlugin(kind, element, device.library);
  device.type = entry->description.label;
  const auto implementation = element.child("implementation");
  const bool is_stand_in = entry->description.free_parameters;  // its library is not loaded
  if (implementation && !is_stand_in) {
    implementation->allowAttributes({});
    const std::string name = implementation->text();
    entry = name.empty() ? nullptr : Registry::instance().find(kind, device.type, name);
    if (entry == nullptr && !reader.loads_libraries && !device.library.empty()) {
      entry = &reader.standIn(kind, device.type);
    }
    if (entry == nullptr) {
      implementation->refuse(unknownName("implementation", name, implementationsOf(kind, device.type)));
    }
  } else if (!implementation && !is_stand_in && !Registry::instance().hasDefault(kind, device.type)) {
    element.refuse("found no <implementation> of " + std::string(toString(kind)) + " '" + device.type +
                   "', which has no default, allowed: " + joinNames(implementationsOf(kind, device.type)));
  }
  device.implementation = entry->description.implementation;
  element.child("realism");  // refuses a second one; applyRealism has read the first
  refuseErrorParameter(element, entry->description);
  std::vector<std::string> others = valuesOf(path);
  others.emplace_back("error");
  device.parameters = readPluginParameters(element, entry->description, others);
  if (!is_stand_in) {
    takeFileOf(element, device.parameters, reader);
  }
  device.errors = readErrors(element, is_stand_in ? "" : device.type);
  return device;
}

std::vector<DeviceDescription> readDevices(PluginKind kind, const XmlElement& section, Reader& reader) {
  section.allowAttributes({});
  section.refuseText();
  std::vector<DeviceDescription> devices;
  for (const XmlElement& element : section.children()) {
    devices.push_back(readDevice(kind, element, reader));
    const auto same = [&](const DeviceDescription& other) { return other.type == devices.back().type; };
    if (std::count_if(devices.begin(), devices.end(), same) > 1) {
      element.refuse("found a second " + std::string(toString(kind)) + " '" + devices.back().type + "', allowed: one");
    }
  }
  return devices;
}

/// Completes the label and the library of a C++ controller. @throws ConfigError if there is none with that name
void findController(const XmlElement& element, ControllerDescription& controller, Reader& reader) {
  controller.label = withoutAlias(element.name());
  const Registry& registry = Registry::instance();
  const bool is_known = registry.find(PluginKind::kController, controller.label) != nullptr;
  controller.library = withoutAlias(element.attribute("library").value_or(is_known ? "" : controller.label));
  if (!controller.library.empty()) {
    reader.needLibrary(controller.library, element.attributeLocation("library"));
  }
  const Registry::Entry* entry = registry.find(PluginKind::kController, controller.label);
  if (entry == nullptr && reader.loads_libraries) {
    element.refuse(unknownName("controller", element.name(), registry.labels(PluginKind::kController)));
  }
  if (entry != nullptr) {
    refuseSecondLibrary(*entry, element, controller.library);
    controller.label = entry->description.label;
  }
}

}  // namespace

void readControllers(const XmlElement& section, Reader& reader) {
  section.allowAttributes({});
  section.refuseText();
  for (const XmlElement& element : section.children()) {
    element.allowAttributes(attributesOf("controllers/*"));
    ControllerDescription controller;
    controller.location = element.location();
    controller.id = element.requireAttribute("id");
    reader.takeId("controller", controller.id, element);
    controller.label = element.name();
    controller.script = readScript(element, reader);
    if (controller.script.empty()) {
      findController(element, controller, reader);
    }
    std::vector<std::string> allowed = tagsIn("controllers/*");
    const std::vector<std::string> values = valuesOf("controllers/*");
    allowed.insert(allowed.end(), values.begin(), values.end());
    element.allowChildren(allowed);
    element.child("realism");  // refuses a second one; applyRealism has read the first
    if (const auto actuators = element.child("actuators")) {
      controller.actuators = readDevices(PluginKind::kActuator, *actuators, reader);
    }
    if (const auto sensors = element.child("sensors")) {
      controller.sensors = readDevices(PluginKind::kSensor, *sensors, reader);
    }
    controller.parameters = Configuration("parameters", "", element.location());
    if (const auto parameters = element.child("parameters")) {
      controller.parameters = readFreeParameters(*parameters);
    }
    reader.experiment.controllers.push_back(std::move(controller));
  }
}

}  // namespace swarmanoid::experiment
