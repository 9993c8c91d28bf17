#include "robot_parameters.hpp"

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/parameter_reader.hpp"
#include "swarmanoid_hosts/ros/parameters.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid {
namespace {

std::vector<KnownDevice> knownDevices() {
  std::vector<KnownDevice> known;
  for (const DeviceTopic* topic : deviceTopics()) {
    if (known.empty() || known.back().type != topic->device) {
      const DeviceType* type = findDeviceType(topic->device);
      known.push_back(
          {topic->device, topic->kind == DeviceTopic::Kind::kReading, type == nullptr ? "" : type->robot, {}});
    }
    known.back().topics.push_back(topic->name);
  }
  return known;
}

}  // namespace

std::string readRobotName(const ros::NodeHandle& own) {
  std::string name = ParameterReader(own).text("robots", "");
  if (name.empty() || name.find_first_of(" /") != std::string::npos) {
    throw ConfigError({own.getNamespace() + "/robots", 0},
                      "found '" + name + "', allowed with provider:=topics: the name of one robot");
  }
  return name;
}

RobotConfiguration readRobotConfiguration(const ros::NodeHandle& own) {
  const std::string path = own.getNamespace() + "/configuration";
  XmlRpc::XmlRpcValue values;
  if (!own.getParam("configuration", values)) {
    throw ConfigError({path, 0}, "found nothing, allowed: the robot's configuration; set configuration:=FILE.yaml");
  }
  return readRobotConfiguration(configurationFrom(values, "configuration", path), knownDevices());
}

const Registry::Entry& findController(const ros::NodeHandle& own, const std::string& given_label) {
  ParameterReader reader(own);
  const std::string label = given_label.empty() ? reader.text("controller", "") : given_label;
  if (label.empty()) {
    throw ConfigError({own.getNamespace() + "/controller", 0}, "found nothing, allowed: the label of a controller");
  }
  if (Registry::instance().find(PluginKind::kController, label) == nullptr) {
    loadPluginLibrary(reader.text("library", label), {}, {own.getNamespace() + "/library", 0});
  }
  return Registry::instance().require(PluginKind::kController, label);
}

}  // namespace swarmanoid
