/// Robots' logs in the ROS log.
#pragma once

#include <string>

#include "swarmanoid_interface/robot.hpp"

namespace swarmanoid {

/// A Robot::LogSink: to rosout and the console, with the robot's name before the text. From any thread.
void logRobot(LogLevel level, const std::string& robot, const std::string& text);

}  // namespace swarmanoid
