// The eyebot's velocity controller: it limits the length of velocities, and adds gusts if configured.
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"

#include <algorithm>
#include <cmath>

#include "common/mechanisms.hpp"
#include "common/parameters.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

class EyebotVelocityActuator final : public ActuatorOf<EyebotVelocity> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = EyebotVelocity::kType;
    description.implementation = "default";
    description.is_default = true;
    description.mechanisms = {flight()};
    description.summary = "A desired velocity in the robot's own frame, and a yaw rate.";
    description.parameters = {
        number("max_speed", "m/s", numberText(EyebotVelocity::kUsualFastest), {0.0, 5.0},
               "The longest velocity that is flown."),
        number("max_yaw_rate", "rad/s", numberText(EyebotVelocity::kUsualFastestTurn), {0.0, 10.0},
               "The fastest turn."),
        number("noise", "m/s", "0", {0.0, 1.0},
               "Standard deviation added to each component of the velocity, also while it hovers.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    max_speed_ = parameters.number("max_speed", EyebotVelocity::kUsualFastest);
    max_yaw_rate_ = parameters.number("max_yaw_rate", EyebotVelocity::kUsualFastestTurn);
    addErrorAlias("gaussian", "linear", "deviation", parameters.number("noise", 0.0));
  }

 protected:
  void limit(const Space& /*space*/, BasicActuatorInstance<EyebotVelocity>& instance) override {
    EyebotVelocity& velocity = *instance.actuation;
    const double speed = velocity.linear.norm();
    if (!std::isfinite(speed)) {
      // the components are finite, but their square may overflow
      velocity.linear /= velocity.linear.cwiseAbs().maxCoeff();
      velocity.linear *= max_speed_ / velocity.linear.norm();
    } else if (speed > max_speed_) {
      velocity.linear *= max_speed_ / speed;
    }
    velocity.yaw_rate = std::clamp(velocity.yaw_rate, -max_yaw_rate_, max_yaw_rate_);
  }

  void apply(const Space& /*space*/, const ActuateAccess& access,
             BasicActuatorInstance<EyebotVelocity>& instance) override {
    access.flight[instance.row] = {true, instance.actuation->linear, instance.actuation->yaw_rate};
  }

 private:
  double max_speed_ = EyebotVelocity::kUsualFastest;
  double max_yaw_rate_ = EyebotVelocity::kUsualFastestTurn;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::EyebotVelocityActuator)
