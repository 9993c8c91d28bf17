/// Limits of hosts without ROS.
#pragma once

#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {

/// Such a host receives no frames and topics of other processes.
/// @throws ConfigError for the first robot that another process commands
void refuseRobotsOfOthers(const Experiment& experiment);

}  // namespace swarmanoid
