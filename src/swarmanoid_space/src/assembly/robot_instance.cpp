#include "robot_instance.hpp"

namespace swarmanoid {

const std::vector<DeviceUse>& devicesOf(const ControllerGroup* group) {
  static const std::vector<DeviceUse> none;
  return group == nullptr ? none : group->devices;
}

}  // namespace swarmanoid
