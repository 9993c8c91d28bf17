/// Writes the logs of robots to the ROS log.
#pragma once

#include <string>

#include "swarmanoid_interface/robot.hpp"

namespace swarmanoid {

/// A Robot::LogSink: writes to rosout and the console, with the robot's name before the text. It may be called from any
/// thread.
void logRobot(LogLevel level, const std::string& robot, const std::string& text);

}  // namespace swarmanoid
