// Wheels: the command is limited by the motors; noise is a factor of the speed, so a standing robot stays at rest.
#include <algorithm>

#include "parameters.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

struct WheelsInstance : BasicActuatorInstance<FootbotWheels> {
  double max_speed = 0.0;  // rad/s
};

class FootbotWheelsActuator final : public ActuatorOf<FootbotWheels, WheelsInstance> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = FootbotWheels::kType;
    description.implementation = "default";
    description.is_default = true;
    description.implementation_aliases = {"dummy_footbot_wheels"};
    description.summary = "Angular velocities of the two treels, limited to the motors' maximum.";
    description.robots = {"footbot"};
    description.parameters = {number("noise", "", "0", {0.0, 1.0},
                                     "Standard deviation of the factor that each wheel's speed is multiplied with.")};
    return description;
  }

  void configure(const Configuration& parameters) override { noise_ = parameters.number("noise", 0.0); }

 protected:
  void prepareInstance(const Space& space, WheelsInstance& instance) override {
    instance.max_speed = space.entities.model[static_cast<std::size_t>(instance.row)]->wheels->max_speed;
  }

  void limit(const Space& space, WheelsInstance& instance) override {
    FootbotWheels& wheels = *instance.actuation;
    if (noise_ > 0.0) {
      instance.random.startTick(space.tick);
      wheels.left *= instance.random.gaussian(1.0, noise_);
      wheels.right *= instance.random.gaussian(1.0, noise_);
    }
    wheels.left = std::clamp(wheels.left, -instance.max_speed, instance.max_speed);
    wheels.right = std::clamp(wheels.right, -instance.max_speed, instance.max_speed);
  }

 private:
  double noise_ = 0.0;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::FootbotWheelsActuator)
