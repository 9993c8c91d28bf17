#include "common/unsupported_devices.hpp"

#include <array>

#include "common/turret.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid {
namespace {

/// What a robot must have for a device that engines carry out.
struct Need {
  const char* device;
  const char* part;
  bool (*has)(const EntityModel& model);
};

constexpr const char* kNoTurret = "turret: no joint 'turret' that turns without end about its z axis";

constexpr std::array<Need, 8> kNeeds{{
    {FootbotWheels::kType, "wheels", [](const EntityModel& model) { return model.wheels.has_value(); }},
    {FootbotTurret::kType, kNoTurret, [](const EntityModel& model) { return turretJoint(model) >= 0; }},
    {FootbotTurretState::kType, kNoTurret, [](const EntityModel& model) { return turretJoint(model) >= 0; }},
    {FootbotGripper::kType, "gripper", [](const EntityModel& model) { return model.gripper.has_value(); }},
    {HandbotArms::kType, "arms", [](const EntityModel& model) { return model.findJoint("left_shoulder") >= 0; }},
    {HandbotHands::kType, "hands", [](const EntityModel& model) { return model.mounts.count("left_suction") > 0; }},
    {HandbotRope::kType, "rope", [](const EntityModel& model) { return model.mounts.count("rope_launcher") > 0; }},
    {EyebotMagnet::kType, "magnet", [](const EntityModel& model) { return model.mounts.count("magnet") > 0; }},
}};

}  // namespace

std::string unsupportedDevicesReason(const EntityModel& model, const std::vector<std::string>& devices) {
  if (model.shapes.empty()) {
    return "has no shape, so this engine has nothing to hold";
  }
  bool is_driven = false;
  for (const std::string& device : devices) {
    for (const Need& need : kNeeds) {
      if (device == need.device && !need.has(model)) {
        return "device '" + device + "' cannot be simulated: a robot of this type has no " + need.part;
      }
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
