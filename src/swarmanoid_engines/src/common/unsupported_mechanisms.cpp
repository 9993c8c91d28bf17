#include "common/unsupported_mechanisms.hpp"

#include <algorithm>

namespace swarmanoid {
namespace {

bool isDrive(const Mechanism& mechanism) {
  return mechanism.kind == Mechanism::Kind::kWheels || mechanism.kind == Mechanism::Kind::kFlight;
}

/// The joint or holder that both refer to, such as "joint 'turret'"; "joints" if they refer to all of a robot; "" if
/// there is none.
std::string commonPart(const Mechanism& a, const Mechanism& b) {
  const bool is_joint = a.kind == Mechanism::Kind::kJoint;
  const bool is_part = is_joint || a.kind == Mechanism::Kind::kHolder;
  if (a.kind != b.kind || !is_part || (a.name != b.name && !a.name.empty() && !b.name.empty())) {
    return "";
  }
  const std::string& name = a.name.empty() ? b.name : a.name;
  const std::string part = is_joint ? "joint" : "holder";
  return name.empty() ? part + "s" : part + " '" + name + "'";
}

/// The joint or holder that both devices command; "" if there is none.
std::string commonPart(const DeviceUse& a, const DeviceUse& b) {
  if (a.kind != DeviceKind::kActuator || b.kind != DeviceKind::kActuator) {
    return "";
  }
  for (const Mechanism& of_a : a.mechanisms) {
    for (const Mechanism& of_b : b.mechanisms) {
      if (std::string part = commonPart(of_a, of_b); !part.empty()) {
        return part;
      }
    }
  }
  return "";
}

}  // namespace

std::string unsupportedMechanismsReason(const EntityModel& model, const std::vector<DeviceUse>& devices) {
  if (model.shapes.empty()) {
    return "has no shape, so this engine has nothing to hold";
  }
  bool is_driven = false;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const DeviceUse& device = devices[i];
    const std::string begin = "device '" + device.type + "' cannot be simulated: ";
    for (const Mechanism& mechanism : device.mechanisms) {
      if (const std::string part = model.missingPart(mechanism); !part.empty()) {
        return begin + "a robot of this type has no " + part;
      }
    }
    const bool is_drive = device.kind == DeviceKind::kActuator &&
                          std::any_of(device.mechanisms.begin(), device.mechanisms.end(), isDrive);
    if (is_drive && is_driven) {
      return begin + "another device drives the robot already";
    }
    is_driven = is_driven || is_drive;
    for (std::size_t k = 0; k < i; ++k) {
      if (const std::string part = commonPart(devices[k], device); !part.empty()) {
        return begin + "the device '" + devices[k].type + "' commands the robot's " + part + " already";
      }
    }
  }
  return "";
}

bool worksWith(const DeviceUse& device, Mechanism::Kind kind, const std::string& name) {
  return std::any_of(device.mechanisms.begin(), device.mechanisms.end(), [&](const Mechanism& mechanism) {
    return mechanism.kind == kind && (mechanism.name.empty() || mechanism.name == name);
  });
}

}  // namespace swarmanoid
