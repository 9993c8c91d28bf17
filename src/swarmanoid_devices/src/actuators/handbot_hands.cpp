// Hands: the engine that moves the robot computes the holding; this device only passes the command on.
#include "swarmanoid_interface/devices/handbot_hands.hpp"

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
    description.summary = "Suction of each hand, on or off.";
    description.robots = {"handbot"};
    return description;
  }

  void configure(const Configuration&) override {}
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::HandbotHandsActuator)
