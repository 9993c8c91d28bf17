// Hands: the engine that moves the robot computes the holding; this device only passes the command on.
#include "swarmanoid_interface/devices/handbot_hands.hpp"

#include "mechanisms.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotHandsActuator final : public ActuatorOf<HandbotHands> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotHands::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {holder("left hand"), holder("right hand")};
    description.summary = "Suction of each hand, on or off.";
    description.robots = {"handbot"};
    return description;
  }

  void configure(const Configuration&) override {}

 protected:
  void apply(Space& space, BasicActuatorInstance<HandbotHands>& instance) override {
    command(space, instance.row, "left hand", instance.actuation->left);
    command(space, instance.row, "right hand", instance.actuation->right);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::HandbotHandsActuator)
