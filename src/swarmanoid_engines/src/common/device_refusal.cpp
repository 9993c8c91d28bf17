#include "common/device_refusal.hpp"

#include "common/turret.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"

namespace swarmanoid {

std::string deviceRefusal(const EntityModel& model, const std::vector<std::string>& devices) {
  if (model.shapes.empty()) {
    return "has no shape, so this engine has nothing to hold";
  }
  const auto lacks = [](const std::string& device, const char* part) {
    return "device '" + device + "' cannot be simulated: a robot of this type has no " + part;
  };
  bool is_driven = false;
  for (const std::string& device : devices) {
    if (device == FootbotWheels::kType && !model.wheels) {
      return lacks(device, "wheels");
    }
    if (device == FootbotGripper::kType && !model.gripper) {
      return lacks(device, "gripper");
    }
    if ((device == FootbotTurret::kType || device == FootbotTurretState::kType) && turretJoint(model) < 0) {
      return lacks(device, "turret: no joint 'turret' that turns without end about its z axis");
    }
    const bool is_drive = device == FootbotWheels::kType || device == EyebotVelocity::kType;
    if (is_drive && is_driven) {
      return "device '" + device + "' cannot be simulated: another device drives the robot already";
    }
    is_driven = is_driven || is_drive;
  }
  return "";
}

}  // namespace swarmanoid
