/// Defines the topics of devices/rfid.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/RfidTags.h>
#include <swarmanoid_msgs/RfidWriteCommand.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/same_length.hpp"
#include "swarmanoid_interface/devices/rfid.hpp"

namespace swarmanoid {

inline void toMessage(const RfidReader& readings, swarmanoid_msgs::RfidTags& message) {
  message.ids.resize(readings.tags.size());
  message.data.resize(readings.tags.size());
  for (std::size_t i = 0; i < readings.tags.size(); ++i) {
    message.ids[i] = readings.tags[i].id;
    message.data[i] = readings.tags[i].data;
  }
  message.overflowed = readings.overflowed;
}

/// The readings are stored in `parts`.
inline void fromMessage(const swarmanoid_msgs::RfidTags& message, RfidReader& readings, VariableParts& parts) {
  const std::size_t count =
      sameLength({{"ids", message.ids.size()}, {"data", message.data.size()}}, RfidReader::kMostTags);
  parts.clear();
  RfidTagReading* tags = parts.room<RfidTagReading>(count);
  for (std::size_t i = 0; i < count; ++i) {
    tags[i] = {message.ids[i], message.data[i]};
  }
  readings.tags = Span<const RfidTagReading>(tags, count);
  readings.overflowed = message.overflowed != 0;
}

inline void toMessage(const RfidWriter& command, swarmanoid_msgs::RfidWriteCommand& message) {
  message.writes = command.writes;
  message.id = command.id;
  message.data = command.data;
}

inline void fromMessage(const swarmanoid_msgs::RfidWriteCommand& message, RfidWriter& command) {
  command = {message.writes != 0, message.id, message.data};
}

REGISTER_DEVICE_TOPIC(RfidReader, swarmanoid_msgs::RfidTags, kReading, "rfid/tags", "base_link")
REGISTER_DEVICE_TOPIC(RfidWriter, swarmanoid_msgs::RfidWriteCommand, kCommand, "rfid/command")

}  // namespace swarmanoid
