/// What space and participants tell each other, as messages.
#pragma once

#include <swarmanoid_msgs/CommandFrame.h>
#include <swarmanoid_msgs/Register.h>
#include <swarmanoid_msgs/SensorFrame.h>

#include "swarmanoid_interface/frames.hpp"

namespace swarmanoid {

void toMessage(const SensorFrame& frame, swarmanoid_msgs::SensorFrame& message);
SensorFrame fromMessage(const swarmanoid_msgs::SensorFrame& message);

void toMessage(const CommandFrame& frame, swarmanoid_msgs::CommandFrame& message);
CommandFrame fromMessage(const swarmanoid_msgs::CommandFrame& message);

/// All but `success` and `message`.
void toMessage(const Registration& registration, swarmanoid_msgs::Register::Response& message);
Registration fromMessage(const swarmanoid_msgs::Register::Response& message);

}  // namespace swarmanoid
