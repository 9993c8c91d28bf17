// Gripper: this device only passes the command on; the engine that moves the robot computes the grip.
#include "swarmanoid_interface/devices/footbot_gripper.hpp"

#include "common/holders.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotGripperActuator final : public HolderActuator<FootbotGripperActuator, FootbotGripper> {
 public:
  static constexpr std::array<const char*, 1> kHolders{"gripper"};

  static PluginDescription describe() {
    PluginDescription description;
    description.label = FootbotGripper::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {holder(kHolders[0])};
    description.implementation_aliases = {"dummy_footbot_gripper"};
    description.summary = "Closes the gripper on an object within reach, or opens it.";
    return description;
  }

 protected:
  void apply(const Space& /*space*/, const ActuateAccess& access, Instance& instance) override {
    command(access, instance, 0, instance.actuation->closed);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::FootbotGripperActuator)
