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

std::string fieldNames(const DeviceType& device) {
  std::string text;
  const auto append = [&text](const std::string& name) {
    text += (text.empty() || text.back() == '(' ? "" : " ") + name;
  };
  for (const DeviceNumber& number : device.numbers) {
    append(number.name);
    if (number.kind == DeviceNumber::Kind::kSpan) {
      text += "(";
      for (const DeviceNumber& element : number.elements) {
        append(element.name);
      }
      text += ")";
    }
  }
  return text;
}

std::string includedAs(const std::string& file) {
  const std::string folder = "/include/";
  const std::string path = "/" + file;  // relative paths may begin with that folder
  const std::size_t found = path.rfind(folder);
  return found == std::string::npos ? path.substr(path.rfind('/') + 1) : path.substr(found + folder.size());
}

const char* toString(DeviceKind kind) { return kind == DeviceKind::kSensor ? "sensor" : "actuator"; }

}  // namespace swarmanoid
