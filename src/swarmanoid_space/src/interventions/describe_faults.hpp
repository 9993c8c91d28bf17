/// Faults of devices in words.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/error_models/error_model_description.hpp"

namespace swarmanoid {

/// Returns "stuck on value[3], gaussian (deviation 0.02) on value from tick 300"; "mended" without any fault. Faults
/// with the same text have the same effect. @param errors complete: parameters of known kinds, with their defaults
std::string describeFaults(const std::vector<ErrorModelDescription>& errors);

}  // namespace swarmanoid
