// Magnet: this device only passes the command on; the engine that moves the robot computes the attachment.
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"

#include "common/holders.hpp"

namespace swarmanoid::devices {
namespace {

class EyebotMagnetActuator final : public HolderActuator<EyebotMagnetActuator, EyebotMagnet> {
 public:
  static constexpr auto kHolders = kMagnetHolder;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = EyebotMagnet::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {holder(kHolders[0])};
    description.summary = "The magnet that holds on to ferromagnetic ceilings, on or off.";
    return description;
  }

 protected:
  void apply(const Space& /*space*/, const ActuateAccess& access, Instance& instance) override {
    command(access, instance, 0, instance.actuation->on);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::EyebotMagnetActuator)
