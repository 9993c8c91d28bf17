/// Converts the result of a run to a message and to a line for the log.
#pragma once

#include <std_msgs/Header.h>
#include <swarmanoid_msgs/RunResult.h>

#include <string>

#include "swarmanoid_space/simulation/run_result.hpp"

namespace swarmanoid {

swarmanoid_msgs::RunResult toMessage(const RunResult& result, const std_msgs::Header& header);

/// Returns "finished after 431 ticks; success; prey = yellow, ..."
std::string describe(const RunResult& result);

}  // namespace swarmanoid
