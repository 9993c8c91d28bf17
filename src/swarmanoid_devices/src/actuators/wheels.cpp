// The wheels of any robot with a differential drive.
#include "swarmanoid_interface/devices/wheels.hpp"

#include "wheel_drive.hpp"

namespace swarmanoid::devices {
namespace {

class WheelsActuator final : public WheelSpeedActuator<WheelsActuator, Wheels> {
 public:
  static PluginDescription describe() {
    return describeDrive("Angular velocities of the two wheels, limited to the motors' maximum.");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_ACTUATOR(swarmanoid::devices::WheelsActuator)
