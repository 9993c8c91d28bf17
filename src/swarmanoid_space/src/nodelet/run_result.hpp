/// What came out of a run, as a message and as a line for the log.
#pragma once

#include <swarmanoid_msgs/RunResult.h>

#include <string>

#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid {

swarmanoid_msgs::RunResult runResult(const Simulation& simulation, bool finished, const std::string& message,
                                     double wall_s);

/// "finished after 431 ticks; success; prey = yellow, ..."
std::string describe(const swarmanoid_msgs::RunResult& result);

}  // namespace swarmanoid
