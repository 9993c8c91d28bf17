/// The fields that a neural network reads and commands: fields of any devices in its configuration, found by the
/// devices' descriptors. The parameters mirror the devices: a tag for each device, and in it a tag for each field.
///
///     <inputs>
///       <footbot_proximity> <value groups="8"/> </footbot_proximity>
///       <light> <sensors> <value sectors="8"/> </sensors> </light>
///     </inputs>
///     <outputs>
///       <footbot_wheels> <left minimum="-5" maximum="5"/> <right minimum="-5" maximum="5"/> </footbot_wheels>
///     </outputs>
///
/// Devices are ordered by name and fields as in the descriptor, independent of the order in the file.
/// docs/reference/neural_controllers.md has the attributes and the scaling.
///
/// Threads  const after construction, except the devices of the robot, which one thread at a time uses.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/number_place.hpp"
#include "swarmanoid_interface/robot.hpp"

namespace swarmanoid::neural {

/// A field in <inputs> or <outputs>, with its device.
struct Port {
  const DeviceType* type = nullptr;
  const FieldDescription* field = nullptr;
  std::vector<NumberPlace> places;     ///< of the field's numbers, in the device or in an element of its list
  const DeviceNumber* span = nullptr;  ///< list that contains the field; null if none does
  Range range;                         ///< range that values are scaled to
  const Configuration* parameters = nullptr;
};

/// Returns the fields of sensors or of actuators that <inputs> or <outputs> lists. @throws ConfigError
std::vector<Port> portsOf(const Robot& robot, const Configuration& element, DeviceKind kind);

/// Reads the attributes minimum and maximum; scalingBoundsOf is the default. @throws ConfigError
void takeRange(Port& port);

/// Reads the attribute count of a field outside lists, and keeps only that many of its numbers. @throws ConfigError
void takeCount(Port& port);

/// @throws ConfigError "found the field 'value' of light<found>, allowed: <allowed>"
[[noreturn]] void refuse(const Port& port, const std::string& found, const std::string& allowed);

}  // namespace swarmanoid::neural
