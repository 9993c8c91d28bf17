// The footbot's treels.
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

#include "slipping_wheels.hpp"

namespace swarmanoid::devices {
namespace {

class FootbotWheelsActuator : public WheelSpeedActuator<FootbotWheelsActuator, FootbotWheels> {
 public:
  static PluginDescription describe() {
    PluginDescription description =
        describeDrive("Angular velocities of the two treels, limited to the motors' maximum.");
    description.implementation_aliases = {"dummy_footbot_wheels"};
    description.parameters = {
        number("noise", "", "0", {0.0, 1.0},
               "Standard deviation of a factor on each wheel's speed; a wheel at rest is not affected.")};
    return description;
  }

  void configure(const Configuration& parameters) override {
    addErrorAlias("factor", "", "deviation", parameters.number("noise", 0.0));
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_WHEEL_DRIVE(swarmanoid::devices::FootbotWheelsActuator)
