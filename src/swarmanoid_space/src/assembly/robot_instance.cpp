#include "robot_instance.hpp"

namespace swarmanoid {

std::vector<std::string> devicesOf(const ControllerGroup* group) {
  std::vector<std::string> devices;
  if (group != nullptr) {
    for (const auto& sensor : group->sensors) {
      devices.emplace_back(sensor->type());
    }
    for (const auto& actuator : group->actuators) {
      devices.emplace_back(actuator->type());
    }
  }
  return devices;
}

}  // namespace swarmanoid
