/// Metrics in messages and logs.
#pragma once

#include <swarmanoid_msgs/TextParameter.h>

#include <string>
#include <vector>

#include "swarmanoid_space/metrics.hpp"

namespace swarmanoid {

/// Numbers with as many digits as their bits need, "true", "false", texts unchanged.
std::string metricText(const Metrics::mapped_type& value);

/// All metrics, in their order.
std::vector<swarmanoid_msgs::TextParameter> toMessages(const Metrics& metrics);

}  // namespace swarmanoid
