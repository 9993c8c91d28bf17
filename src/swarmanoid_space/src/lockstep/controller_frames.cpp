#include "swarmanoid_space/lockstep/controller_frames.hpp"

#include <stdexcept>

#include "swarmanoid_interface/frame_parts.hpp"

namespace swarmanoid {
namespace {

std::vector<DeviceLayout> layoutsOf(const std::vector<DeviceDescription>& devices) {
  std::vector<DeviceLayout> layouts;
  for (const DeviceDescription& device : devices) {
    const DeviceType* type = findDeviceType(device.type);
    if (type == nullptr) {
      throw std::runtime_error("device '" + device.type +
                               "' cannot travel to another process: no REGISTER_DEVICE says which fields it has");
    }
    layouts.push_back({type->type, type->layout, fieldNames(*type)});
  }
  return layouts;
}

void writeAll(const Banks& banks, Row row, const std::vector<DeviceLayout>& devices, ByteWriter& out) {
  for (const DeviceLayout& device : devices) {
    writeBlock(*findDeviceType(device.type), banks.find(device.type, row), out);
  }
}

}  // namespace

RemoteRobot describeRobot(const Robot& robot, const ControllerDescription& controller) {
  return {robot.name(),
          robot.type(),
          controller.id,
          controller.label,
          layoutsOf(controller.sensors),
          layoutsOf(controller.actuators),
          controller.parameters};
}

void writeReadings(const Space& space, Row row, const std::vector<DeviceLayout>& sensors, ByteWriter& out) {
  writeAll(space.readings, row, sensors, out);
}

void writeCommands(const Space& space, Row row, const std::vector<DeviceLayout>& actuators, ByteWriter& out) {
  writeAll(space.commands, row, actuators, out);
}

}  // namespace swarmanoid
