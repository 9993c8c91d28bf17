// Hands: this device only passes the command on; the engine that moves the robot computes the attachments.
#include "swarmanoid_interface/devices/handbot_hands.hpp"

#include "common/holders.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotHandsActuator final : public HolderActuator<HandbotHandsActuator, HandbotHands, 2> {
 public:
  static constexpr auto kHolders = kHandHolders;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotHands::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {holder(kHolders[0]), holder(kHolders[1])};
    description.summary = "Suction of each hand, on or off.";
    return description;
  }

 protected:
  void apply(const Space& /*space*/, const ActuateAccess& access, Instance& instance) override {
    command(access, instance, 0, instance.actuation->left);
    command(access, instance, 1, instance.actuation->right);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::HandbotHandsActuator)
