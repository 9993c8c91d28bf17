#include "common/unsupported_mechanisms.hpp"

#include <algorithm>

namespace swarmanoid {
namespace {

bool isDrive(const Mechanism& mechanism) {
  return mechanism.kind == Mechanism::Kind::kWheels || mechanism.kind == Mechanism::Kind::kFlight;
}

}  // namespace

std::string unsupportedMechanismsReason(const EntityModel& model, const std::vector<DeviceUse>& devices) {
  if (model.shapes.empty()) {
    return "has no shape, so this engine has nothing to hold";
  }
  bool is_driven = false;
  for (const DeviceUse& device : devices) {
    const std::string begin = "device '" + device.type + "' cannot be simulated: ";
    for (const Mechanism& mechanism : device.mechanisms) {
      if (const std::string part = model.missingPart(mechanism); !part.empty()) {
        return begin + "a robot of this type has no " + part;
      }
    }
    const bool is_drive = std::any_of(device.mechanisms.begin(), device.mechanisms.end(), isDrive);
    if (is_drive && is_driven) {
      return begin + "another device drives the robot already";
    }
    is_driven = is_driven || is_drive;
  }
  return "";
}

}  // namespace swarmanoid
