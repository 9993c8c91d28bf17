/// Defines the topics of devices/holders.hpp, and converts its devices to messages and back.
#pragma once

#include <swarmanoid_msgs/HoldersCommand.h>
#include <swarmanoid_msgs/HoldersState.h>

#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_hosts/ros/same_length.hpp"
#include "swarmanoid_interface/devices/holders.hpp"

namespace swarmanoid {

inline void toMessage(const Holders& command, swarmanoid_msgs::HoldersCommand& message) {
  message.holds.clear();
  message.winding_speeds.clear();
  for (const Holders::Holder& holder : command.holders) {
    message.holds.push_back(static_cast<std::uint8_t>(holder.holds));
    message.winding_speeds.push_back(holder.winding_speed);
  }
}

/// Holders that the message does not include keep their commands.
inline void fromMessage(const swarmanoid_msgs::HoldersCommand& message, Holders& command) {
  const std::size_t count =
      sameLength({{"holds", message.holds.size()}, {"winding_speeds", message.winding_speeds.size()}}, Holders::kMost);
  for (std::size_t i = 0; i < count; ++i) {
    command.holders[i] = {message.holds[i] != 0, message.winding_speeds[i]};
  }
}

inline void toMessage(const HolderStates& readings, swarmanoid_msgs::HoldersState& message) {
  message.is_holding.clear();
  message.lengths.clear();
  message.forces.clear();
  for (const HolderStates::Holder& holder : readings.holders) {
    message.is_holding.push_back(static_cast<std::uint8_t>(holder.is_holding));
    message.lengths.push_back(holder.length);
    message.forces.push_back(holder.force);
  }
}

/// The readings are stored in `parts`.
inline void fromMessage(const swarmanoid_msgs::HoldersState& message, HolderStates& readings, VariableParts& parts) {
  const std::size_t count = sameLength({{"is_holding", message.is_holding.size()},
                                        {"lengths", message.lengths.size()},
                                        {"forces", message.forces.size()}},
                                       HolderStates::kMost);
  parts.clear();
  auto* holders = parts.room<HolderStates::Holder>(count);
  for (std::size_t i = 0; i < count; ++i) {
    holders[i] = {message.is_holding[i] != 0, message.lengths[i], message.forces[i]};
  }
  readings.holders = Span<const HolderStates::Holder>(holders, count);
}

REGISTER_DEVICE_TOPIC(Holders, swarmanoid_msgs::HoldersCommand, kCommand, "holders/command")
REGISTER_DEVICE_TOPIC(HolderStates, swarmanoid_msgs::HoldersState, kReading, "holders/state", "base_link")

}  // namespace swarmanoid
