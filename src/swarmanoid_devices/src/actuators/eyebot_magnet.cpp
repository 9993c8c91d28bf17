// Magnet: the engine that moves the robot computes the holding; this device only passes the command on.
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"

#include "mechanisms.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

class EyebotMagnetActuator final : public ActuatorOf<EyebotMagnet> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = EyebotMagnet::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {holder("magnet")};
    description.summary = "The magnet that holds on to ferromagnetic ceilings, on or off.";
    description.robots = {"eyebot"};
    return description;
  }

  void configure(const Configuration&) override {}

 protected:
  void apply(Space& space, BasicActuatorInstance<EyebotMagnet>& instance) override {
    command(space, instance.row, "magnet", instance.actuation->on);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::EyebotMagnetActuator)
