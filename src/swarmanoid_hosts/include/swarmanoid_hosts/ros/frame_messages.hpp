/// What space and participants send each other, and what is recorded of it, as messages.
#pragma once

#include <swarmanoid_msgs/CommandFrame.h>
#include <swarmanoid_msgs/ControllerStart.h>
#include <swarmanoid_msgs/Register.h>
#include <swarmanoid_msgs/SensorFrame.h>

#include <map>
#include <string>

#include "swarmanoid_interface/frames.hpp"

namespace swarmanoid {

/// By the name of a parameter (of nested ones a path: outer/inner) the place where it was given.
using ParameterLocations = std::map<std::string, SourceLocation>;

void toMessage(const SensorFrame& frame, swarmanoid_msgs::SensorFrame& message);
SensorFrame fromMessage(const swarmanoid_msgs::SensorFrame& message);

void toMessage(const CommandFrame& frame, swarmanoid_msgs::CommandFrame& message);
CommandFrame fromMessage(const swarmanoid_msgs::CommandFrame& message);

/// All but `success` and `message`.
void toMessage(const Registration& registration, swarmanoid_msgs::Register::Response& message);
Registration fromMessage(const swarmanoid_msgs::Register::Response& message);

/// One robot of it. The stamp of the header is the caller's.
void toMessage(const Registration& registration, std::size_t robot, swarmanoid_msgs::ControllerStart& message);
/// Of one robot, in session 0.
/// @param elsewhere the parameters that do not come from where the message says
Registration fromMessage(const swarmanoid_msgs::ControllerStart& message, const ParameterLocations& elsewhere = {});

}  // namespace swarmanoid
