// Rope: the winding speed is limited by the motor. The engine that moves the robot computes shooting, winding and
// holding.
#include "swarmanoid_interface/devices/handbot_rope.hpp"

#include "common/holders.hpp"
#include "common/parameters.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotRopeActuator final : public WinchActuator<HandbotRopeActuator, HandbotRope> {
  using Base = WinchActuator<HandbotRopeActuator, HandbotRope>;

 public:
  static constexpr auto kHolders = kRopeHolder;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotRope::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {holder(kHolders[0])};
    description.summary = "Shoots the rope, winds it in and out, lets it go.";
    description.parameters = {fastestWinding(),
                              number("noise", "", "0", {0.0, 1.0},
                                     "Standard deviation of the factor that the winding speed is multiplied with.")};
    return description;
  }

  static double& windingOf(HandbotRope& rope, std::size_t /*which*/) { return rope.winding_speed; }

  void configure(const Configuration& parameters) override {
    Base::configure(parameters);
    addErrorAlias("factor", "winding_speed", "deviation", parameters.number("noise", 0.0));
  }

 protected:
  void apply(const Space& /*space*/, const ActuateAccess& access, Instance& instance) override {
    command(access, instance, 0, instance.actuation->shot, instance.actuation->winding_speed);
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::HandbotRopeActuator)
