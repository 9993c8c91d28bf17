/// Readings and commands of a robot's controller as bytes of frames (swarmanoid_interface/frames.hpp), for transmission
/// to another process or for recording.
#pragma once

#include "swarmanoid_interface/byte_stream.hpp"
#include "swarmanoid_interface/frames.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// @throws std::runtime_error for a device that cannot be transmitted
RemoteRobot describeRobot(const Robot& robot, const ControllerDescription& controller);

/// The readings of a robot in this tick, a block for each sensor.
void writeReadings(const Space& space, Row row, const std::vector<DeviceLayout>& sensors, ByteWriter& out);

/// The commands of a robot, a block for each actuator.
void writeCommands(const Space& space, Row row, const std::vector<DeviceLayout>& actuators, ByteWriter& out);

}  // namespace swarmanoid
