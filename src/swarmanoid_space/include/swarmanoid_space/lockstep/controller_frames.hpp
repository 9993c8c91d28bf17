/// What a robot's controller sees and does, as the bytes of frames (swarmanoid_interface/frames.hpp): for those who
/// carry it to another process, or record it.
#pragma once

#include "swarmanoid_interface/byte_stream.hpp"
#include "swarmanoid_interface/frames.hpp"
#include "swarmanoid_space/space.hpp"

namespace swarmanoid {

/// @throws std::runtime_error for a device that cannot travel
RemoteRobot describeRobot(const Robot& robot, const ControllerDescription& controller);

/// The readings of a robot in this tick, a block for each sensor.
void writeReadings(const Space& space, Row row, const std::vector<DeviceLayout>& sensors, ByteWriter& out);

/// The commands of a robot, a block for each actuator.
void writeCommands(const Space& space, Row row, const std::vector<DeviceLayout>& actuators, ByteWriter& out);

}  // namespace swarmanoid
