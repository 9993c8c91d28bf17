#include "swarmanoid_interface/device_type.hpp"

#include <map>
#include <set>

namespace swarmanoid {
namespace {

std::map<std::string, DeviceType>& types() {
  static std::map<std::string, DeviceType> types;
  return types;
}

}  // namespace

void registerDeviceType(DeviceType type) {
  const std::string name = type.type;
  types().emplace(name, std::move(type));
}

const DeviceType* findDeviceType(const std::string& type) {
  const auto found = types().find(type);
  return found == types().end() ? nullptr : &found->second;
}

std::vector<const DeviceType*> deviceTypes() {
  std::vector<const DeviceType*> result;
  for (const auto& [name, type] : types()) {
    result.push_back(&type);
  }
  return result;
}

std::vector<std::string> robotTypesOfDevices() {
  std::set<std::string> robots;
  for (const auto& [name, type] : types()) {
    if (!type.robot.empty()) {
      robots.insert(type.robot);
    }
  }
  return {robots.begin(), robots.end()};
}

const char* toString(DeviceKind kind) { return kind == DeviceKind::kSensor ? "sensor" : "actuator"; }

}  // namespace swarmanoid
