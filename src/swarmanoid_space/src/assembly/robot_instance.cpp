#include "robot_instance.hpp"

#include "swarmanoid_interface/step_controller.hpp"

namespace swarmanoid {

std::shared_ptr<Controller> startControllerOf(const RobotInstance& instance) {
  const ControllerGroup& group = *instance.group;
  return group.together != nullptr
             ? nullptr
             : startController(group.make, group.part, *instance.robot, group.description->parameters);
}

const std::vector<DeviceUse>& devicesOf(const ControllerGroup* group) {
  static const std::vector<DeviceUse> none;
  return group == nullptr ? none : group->devices;
}

}  // namespace swarmanoid
