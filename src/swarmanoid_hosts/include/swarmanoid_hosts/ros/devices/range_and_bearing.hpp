/// Defines the topics of devices/range_and_bearing.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/RangeAndBearingMessages.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/devices/messages.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid {

inline void toMessage(const RangeAndBearingReceived& readings, swarmanoid_msgs::RangeAndBearingMessages& message) {
  writeReceived(readings, message.messages, [](const RangeAndBearingMessage& from, auto& to) {
    to.range = from.range;
    to.bearing = from.bearing;
    to.elevation = from.elevation;
  });
  message.overflowed = readings.overflowed;
}

/// The messages are stored in `parts`.
inline void fromMessage(const swarmanoid_msgs::RangeAndBearingMessages& message, RangeAndBearingReceived& readings,
                        VariableParts& parts) {
  readReceived(message.messages, readings, parts, [](const auto& from, RangeAndBearingMessage& to) {
    to.range = from.range;
    to.bearing = from.bearing;
    to.elevation = from.elevation;
  });
  readings.overflowed = message.overflowed != 0;
}

REGISTER_DEVICE_TOPIC(RangeAndBearing, swarmanoid_msgs::MessageCommand, kCommand, "range_and_bearing/command")
REGISTER_DEVICE_TOPIC(RangeAndBearingReceived, swarmanoid_msgs::RangeAndBearingMessages, kReading,
                      "range_and_bearing/received", "base_link")

}  // namespace swarmanoid
