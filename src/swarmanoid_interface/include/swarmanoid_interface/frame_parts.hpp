/// Reads and writes the fields of the data of frames (frames.hpp): devices as blocks, and debug values.
#pragma once

#include <vector>

#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/robot.hpp"

namespace swarmanoid {

void writeBlock(const DeviceType& type, const void* device, ByteWriter& out);

/// Reads the next block.
/// @throws ByteError, also for a block that is longer than the device; the device is then partly read
void readBlock(const DeviceType& type, ByteReader& in, void* device, VariableParts& parts);

void writeDebugValues(const std::vector<Robot::DebugValue>& values, ByteWriter& out);
/// @throws ByteError
std::vector<Robot::DebugValue> readDebugValues(ByteReader& in);

}  // namespace swarmanoid
