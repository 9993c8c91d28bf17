/// What hosts of a simulation without ROS cannot do.
#pragma once

#include "swarmanoid_space/experiment_file/experiment.hpp"

namespace swarmanoid {

/// Frames and topics of other processes do not reach such a host.
/// @throws ConfigError for the first robot that another process commands
void refuseRobotsOfOthers(const Experiment& experiment);

}  // namespace swarmanoid
