// Gripper: the engine that moves the robot computes the gripping; this device only passes the command on.
#include "swarmanoid_interface/devices/footbot_gripper.hpp"

#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotGripperActuator final : public ActuatorOf<FootbotGripper> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = FootbotGripper::kType;
    description.implementation = "default";
    description.is_default = true;
    description.implementation_aliases = {"dummy_footbot_gripper"};
    description.summary = "Closes the gripper on what it reaches, or opens it.";
    description.robots = {"footbot"};
    return description;
  }

  void configure(const Configuration&) override {}
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::FootbotGripperActuator)
