/// What a neural network reads and commands: fields of any devices that its configuration lists, found by the devices'
/// descriptors. The parameters are shaped as the devices are: a tag a device, in it a tag a field.
///
///     <inputs>
///       <footbot_proximity> <value groups="8"/> </footbot_proximity>
///       <light> <sensors> <value sectors="8"/> </sensors> </light>
///     </inputs>
///     <outputs>
///       <footbot_wheels> <left minimum="-5" maximum="5"/> <right minimum="-5" maximum="5"/> </footbot_wheels>
///     </outputs>
///
/// The order is that of the devices' names, in a device that of its descriptor, whatever the order in the file is.
/// docs/reference/neural_controllers.md has the attributes and the scaling.
///
/// Threads  const after they are made, but for the devices of their robot, which one thread at a time works on.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "swarmanoid_interface/configuration.hpp"
#include "swarmanoid_interface/device_type.hpp"
#include "swarmanoid_interface/number_place.hpp"
#include "swarmanoid_interface/robot.hpp"

namespace swarmanoid::neural {

/// A field in <inputs> or <outputs>, with the device that has it.
struct Port {
  const DeviceType* type = nullptr;
  const FieldDescription* field = nullptr;
  std::vector<NumberPlace> places;     ///< of the field's numbers, in the device, or in an element of its list
  const DeviceNumber* span = nullptr;  ///< the list that the field is in; null if it is in none
  Range range;                         ///< that is scaled to
  const Configuration* parameters = nullptr;
};

/// Returns the fields that <inputs> or <outputs> names, of sensors or of actuators. @throws ConfigError
std::vector<Port> portsOf(const Robot& robot, const Configuration& element, DeviceKind kind);

/// The bounds that the descriptor gives, or else those of the type of the number; infinite if it has none.
Range boundsOf(const FieldDescription& field);

/// Reads the attributes minimum and maximum, which are boundsOf if they are not given. @throws ConfigError
void takeRange(Port& port);

/// Reads the attribute count of a field in no list, and leaves so many of its numbers. @throws ConfigError
void takeCount(Port& port);

/// @throws ConfigError "found the field 'value' of light<found>, allowed: <allowed>"
[[noreturn]] void refuse(const Port& port, const std::string& found, const std::string& allowed);

}  // namespace swarmanoid::neural
