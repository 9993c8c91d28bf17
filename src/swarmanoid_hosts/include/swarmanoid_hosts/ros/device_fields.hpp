/// Converts any device to swarmanoid_msgs/DeviceFields and back, by its descriptor alone: the message of devices that
/// have none of their own.
///
/// Names are those of the device's numbers: "left", "value[3]"; an element of a list is "blobs[0].bearing". All numbers
/// travel as float64, which has every value of the other types but whole numbers beyond 2^53: those are rounded.
#pragma once

#include <swarmanoid_msgs/DeviceFields.h>
#include <swarmanoid_msgs/DeviceStatus.h>

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Fills names and values; the header stays. @param device of that type
void toMessage(const DeviceType& type, const void* device, swarmanoid_msgs::DeviceFields& message);

/// All numbers with their units, for people. @param device of that type
swarmanoid_msgs::DeviceStatus statusOf(const DeviceType& type, const void* device);

/// Numbers that the message does not name stay as they are; lists become what the message says, without elements empty.
/// @param parts where the elements of lists are kept
/// @throws std::runtime_error, with what was found and what is allowed: names and values that are not as many, names
/// that the device does not have or that stand there twice, elements with a gap or without one of their numbers, values
/// that are not finite (but measured distances) or that the type of the number cannot hold; the device is then
/// unchanged
void fromMessage(const swarmanoid_msgs::DeviceFields& message, const DeviceType& type, void* device,
                 VariableParts& parts);

}  // namespace swarmanoid
