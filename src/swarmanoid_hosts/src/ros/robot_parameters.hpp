/// Reads the private parameters of a robot's host (robot_host.hpp).
#pragma once

#include <ros/node_handle.h>

#include <string>

#include "swarmanoid_hosts/robot_configuration.hpp"
#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid {

/// @throws ConfigError if there is none, or more than one
std::string readRobotName(const ros::NodeHandle& own);

/// Reads the configuration, with the devices that have topics in this process. @throws ConfigError
RobotConfiguration readRobotConfiguration(const ros::NodeHandle& own);

/// Loads the controller's library if necessary. @param given_label the nodelet's, or "" @throws std::runtime_error
const Registry::Entry& findController(const ros::NodeHandle& own, const std::string& given_label);

}  // namespace swarmanoid
