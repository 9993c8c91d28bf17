// Rope: the winding speed is limited by the motor. The engine that moves the robot computes shooting, winding and
// holding.
#include "swarmanoid_interface/devices/handbot_rope.hpp"

#include <algorithm>

#include "holders.hpp"
#include "parameters.hpp"

namespace swarmanoid::devices {
namespace {

class HandbotRopeActuator final : public HolderActuator<HandbotRopeActuator, HandbotRope> {
 public:
  static constexpr auto kHolders = kRopeHolder;

  static PluginDescription describe() {
    PluginDescription description;
    description.label = HandbotRope::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {holder(kHolders[0])};
    description.summary = "Shoots the rope, winds it in and out, lets it go.";
    description.parameters = {number("max_speed", "m/s", numberText(HandbotRope::kUsualFastest), {0.0, 2.0},
                                     "The fastest winding, in and out."),
                              number("noise", "", "0", {0.0, 1.0},
                                     "Standard deviation of the factor that the winding speed is multiplied with.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    max_speed_ = parameters.number("max_speed", HandbotRope::kUsualFastest);
    addErrorAlias("factor", "winding_speed", "deviation", parameters.number("noise", 0.0));
  }

 protected:
  void limit(const Space& /*space*/, Instance& instance) override {
    double& speed = instance.actuation->winding_speed;
    speed = std::clamp(speed, -max_speed_, max_speed_);
  }

  void apply(Space& space, Instance& instance) override {
    command(space, instance, 0, instance.actuation->shot, instance.actuation->winding_speed);
  }

 private:
  double max_speed_ = HandbotRope::kUsualFastest;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::HandbotRopeActuator)
