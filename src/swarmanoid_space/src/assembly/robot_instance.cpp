#include "robot_instance.hpp"

#include "swarmanoid_interface/step_controller.hpp"

namespace swarmanoid {

std::shared_ptr<Controller> startControllerOf(const RobotInstance& instance, Space& space) {
  const ControllerGroup& group = *instance.group;
  if (group.together == nullptr) {
    return startController(group.make, group.part, *instance.robot, group.description->parameters);
  }
  callUserCode({"init", group.part, instance.robot->name()},
               [&] { group.together->start(space, space.commands, instance.row, *instance.robot); });
  return nullptr;
}

const std::vector<DeviceUse>& devicesOf(const ControllerGroup* group) {
  static const std::vector<DeviceUse> none;
  return group == nullptr ? none : group->devices;
}

}  // namespace swarmanoid
