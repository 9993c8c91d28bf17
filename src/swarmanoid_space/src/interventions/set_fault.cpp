// Sets and repairs faults of a robot's device.
#include <utility>

#include "carry_out.hpp"
#include "describe_faults.hpp"
#include "swarmanoid_interface/plain_text.hpp"
#include "swarmanoid_space/error_models/complete_error.hpp"

namespace swarmanoid {
namespace {

[[noreturn]] void refuseDevice(const World& world, const RobotInstance& robot, const std::string& device) {
  std::vector<std::string> names;
  for (const DeviceUse& use : robot.group->devices) {
    names.push_back(use.type);
  }
  const Entities& entities = world.space.entities;
  throw ConfigError({}, entities.model[robot.row]->type + " '" + entities.name[robot.row] +
                            "': " + unknownName("the device", device, names));
}

/// @return null if there is none
template <class Device>
Device* findDevice(const std::vector<Named<Device>>& devices, const std::string& type) {
  for (const Named<Device>& device : devices) {
    if (device->type() == type) {
      return device.get();
    }
  }
  return nullptr;
}

std::vector<ErrorModelDescription> completed(std::vector<ErrorModelDescription> errors) {
  for (ErrorModelDescription& error : errors) {
    completeError(error);
  }
  return errors;
}

/// @return whether the faults differ from the present ones @throws ConfigError if they do not suit the device
template <class Device>
bool change(World& world, Device& device, Row row, const SetFault& intervention) {
  const std::vector<ErrorModelDescription> errors = completed(intervention.errors);
  const std::string text = describeFaults(errors);
  if (text == describeFaults(device.faults(row))) {
    return false;
  }
  device.setFaults(world.space, row, errors);
  world.pending_events.push_back(
      {Event::Kind::kIntervention, intervention.robot, "", intervention.device + ": " + text});
  return true;
}

}  // namespace

bool carryOut(World& world, const SetFault& intervention) {
  const RobotInstance& robot = requireRobot(world, intervention.robot);
  if (Sensor* sensor = findDevice(robot.group->sensors, intervention.device)) {
    return change(world, *sensor, robot.row, intervention);
  }
  if (Actuator* actuator = findDevice(robot.group->actuators, intervention.device)) {
    return change(world, *actuator, robot.row, intervention);
  }
  refuseDevice(world, robot, intervention.device);
}

}  // namespace swarmanoid
