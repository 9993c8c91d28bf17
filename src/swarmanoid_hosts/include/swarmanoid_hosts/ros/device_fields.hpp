/// Converts any device to swarmanoid_msgs/DeviceFields and back, by its descriptor alone, for devices without a message
/// of their own.
///
/// Names are those of the device's numbers: "left", "value[3]"; an element of a list is "blobs[0].bearing". All numbers
/// are sent as float64, which represents all values of the other types exactly, except integers beyond 2^53: those are
/// rounded.
#pragma once

#include <swarmanoid_msgs/DeviceFields.h>
#include <swarmanoid_msgs/DeviceStatus.h>

#include "swarmanoid_interface/device_type.hpp"

namespace swarmanoid {

/// Fills names and values; the header stays. @param device of that type
void toMessage(const DeviceType& type, const void* device, swarmanoid_msgs::DeviceFields& message);

/// Returns all numbers with their units, for people. @param device of that type
swarmanoid_msgs::DeviceStatus statusOf(const DeviceType& type, const void* device);

/// Numbers that the message does not name keep their values; lists are replaced, and become empty if the message has no
/// elements of them.
/// @param parts storage of the elements of lists
/// @throws std::runtime_error with the value found and the allowed values, for names and values of different number,
/// unknown or repeated names, elements with a gap or a missing number, and values that are not finite (except measured
/// distances, and NaN where it is allowed) or that the type of the number cannot hold; the device is then unchanged
void fromMessage(const swarmanoid_msgs::DeviceFields& message, const DeviceType& type, void* device,
                 VariableParts& parts);

}  // namespace swarmanoid
