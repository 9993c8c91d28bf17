#include "swarmanoid_hosts/ros/log.hpp"

#include <ros/console.h>

namespace swarmanoid {

void logRobot(LogLevel level, const std::string& robot, const std::string& text) {
  switch (level) {
    case LogLevel::kInfo:
      ROS_INFO("%s: %s", robot.c_str(), text.c_str());
      break;
    case LogLevel::kWarning:
      ROS_WARN("%s: %s", robot.c_str(), text.c_str());
      break;
    case LogLevel::kError:
      ROS_ERROR("%s: %s", robot.c_str(), text.c_str());
      break;
  }
}

}  // namespace swarmanoid
