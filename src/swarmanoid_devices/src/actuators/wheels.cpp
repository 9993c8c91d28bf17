// The wheels of any robot with a differential drive.
#include "swarmanoid_interface/devices/wheels.hpp"

#include "slipping_wheels.hpp"

namespace swarmanoid::devices {
namespace {

class WheelsActuator : public WheelSpeedActuator<WheelsActuator, Wheels> {
 public:
  static PluginDescription describe() {
    return describeDrive("Angular velocities of the two wheels, limited to the motors' maximum.");
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_WHEEL_DRIVE(swarmanoid::devices::WheelsActuator)
