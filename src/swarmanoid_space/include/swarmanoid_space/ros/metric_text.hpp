/// Metrics in messages and logs.
#pragma once

#include <string>

#include "swarmanoid_space/metrics.hpp"

namespace swarmanoid {

/// Numbers with as many digits as their bits need, "true", "false", texts as they are.
std::string metricText(const Metrics::mapped_type& value);

}  // namespace swarmanoid
