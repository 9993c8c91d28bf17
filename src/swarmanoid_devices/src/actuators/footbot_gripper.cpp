// Gripper: the engine that moves the robot computes the gripping; this device only passes the command on.
#include "swarmanoid_interface/devices/footbot_gripper.hpp"

#include "mechanisms.hpp"
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
    description.mechanisms = {holder("gripper")};
    description.implementation_aliases = {"dummy_footbot_gripper"};
    description.summary = "Closes the gripper on what it reaches, or opens it.";
    description.robots = {"footbot"};
    return description;
  }

  void configure(const Configuration&) override {}

 protected:
  void apply(Space& space, BasicActuatorInstance<FootbotGripper>& instance) override {
    command(space, instance.row, "gripper", instance.actuation->closed);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::FootbotGripperActuator)
