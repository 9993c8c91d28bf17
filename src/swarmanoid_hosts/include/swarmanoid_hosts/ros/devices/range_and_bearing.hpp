/// Defines the topics of devices/range_and_bearing.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/RangeAndBearingMessages.h>

#include <stdexcept>
#include <string>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/devices/messages.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid {

inline void toMessage(const RangeAndBearingReceived& readings, swarmanoid_msgs::RangeAndBearingMessages& message) {
  message.messages.resize(readings.messages.size());
  for (std::size_t i = 0; i < readings.messages.size(); ++i) {
    const RangeAndBearingMessage& from = readings.messages[i];
    swarmanoid_msgs::RangeAndBearingMessage& to = message.messages[i];
    to.range = from.range;
    to.bearing = from.bearing;
    to.elevation = from.elevation;
    to.payload.assign(from.payload.begin(), from.payload.end());
  }
  message.overflowed = readings.overflowed;
}

/// The messages are stored in `parts`.
inline void fromMessage(const swarmanoid_msgs::RangeAndBearingMessages& message, RangeAndBearingReceived& readings,
                        VariableParts& parts) {
  const std::size_t count = message.messages.size();
  if (count > RangeAndBearingReceived::kMostMessages) {
    throw std::runtime_error("found " + std::to_string(count) + " messages, allowed: at most " +
                             std::to_string(RangeAndBearingReceived::kMostMessages));
  }
  parts.clear();
  RangeAndBearingMessage* messages = parts.room<RangeAndBearingMessage>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const swarmanoid_msgs::RangeAndBearingMessage& from = message.messages[i];
    messages[i] = {from.range, from.bearing, from.elevation, {}};
    fromMessage(from.payload, messages[i].payload);
  }
  readings.messages = Span<const RangeAndBearingMessage>(messages, count);
  readings.overflowed = message.overflowed != 0;
}

REGISTER_DEVICE_TOPIC(RangeAndBearing, swarmanoid_msgs::MessageCommand, kCommand, "range_and_bearing/command")
REGISTER_DEVICE_TOPIC(RangeAndBearingReceived, swarmanoid_msgs::RangeAndBearingMessages, kReading,
                      "range_and_bearing/received", "base_link")

}  // namespace swarmanoid
