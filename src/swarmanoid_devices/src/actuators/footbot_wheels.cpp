// Wheels: limited to what the motors can do; noise is a factor of the speed, so a standing robot stands.
#include <algorithm>

#include "parameters.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_space/actuator.hpp"

namespace swarmanoid::devices {
namespace {

struct WheelsSeat : BasicActuatorSeat<FootbotWheels> {
  double max_speed = 0.0;  // rad/s
};

class FootbotWheelsActuator final : public ActuatorOf<FootbotWheels, WheelsSeat> {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = FootbotWheels::kType;
    description.implementation = "default";
    description.implementation_aliases = {"dummy_footbot_wheels"};
    description.summary = "Angular velocities of the two treels, limited to the motors' maximum.";
    description.robots = {"footbot"};
    description.parameters = {number("noise", "", "0", {0.0, 1.0},
                                     "Standard deviation of the factor that each wheel's speed is multiplied with.")};
    return description;
  }

  void configure(const Configuration& parameters) override { noise_ = parameters.number("noise", 0.0); }

 protected:
  void takeSeat(const Space& space, WheelsSeat& seat) override {
    seat.max_speed = space.entities.model[static_cast<std::size_t>(seat.row)]->wheels->max_speed;
  }

  void limit(const Space& space, WheelsSeat& seat) override {
    FootbotWheels& wheels = *seat.actuation;
    if (noise_ > 0.0) {
      seat.random.startTick(space.tick);
      wheels.left *= seat.random.gaussian(1.0, noise_);
      wheels.right *= seat.random.gaussian(1.0, noise_);
    }
    wheels.left = std::clamp(wheels.left, -seat.max_speed, seat.max_speed);
    wheels.right = std::clamp(wheels.right, -seat.max_speed, seat.max_speed);
  }

 private:
  double noise_ = 0.0;
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::FootbotWheelsActuator)
