// The wheels of any robot with a differential drive, commanded by speed and turn rate.
#include "swarmanoid_interface/devices/differential_drive.hpp"

#include "slipping_wheels.hpp"

namespace swarmanoid::devices {
namespace {

class DifferentialDriveActuator : public WheelDriveActuator<DifferentialDriveActuator, DifferentialDrive> {
 public:
  static PluginDescription describe() {
    return describeDrive("Speed and turn rate; each wheel is limited to its motor's maximum.");
  }

  static WheelSpeeds toSpeeds(const DifferentialDrive& command, const EntityModel::Wheels& wheels) {
    const double difference = 0.5 * command.turn_rate * wheels.separation;
    return {(command.speed - difference) / wheels.radius, (command.speed + difference) / wheels.radius};
  }
  static void fromSpeeds(const WheelSpeeds& speeds, const EntityModel::Wheels& wheels, DifferentialDrive& command) {
    command.speed = 0.5 * (speeds.left + speeds.right) * wheels.radius;
    command.turn_rate = (speeds.right - speeds.left) * wheels.radius / wheels.separation;
  }
};

}  // namespace
}  // namespace swarmanoid::devices

REGISTER_WHEEL_DRIVE(swarmanoid::devices::DifferentialDriveActuator)
