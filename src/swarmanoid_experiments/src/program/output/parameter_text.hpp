/// Describes the allowed values of a parameter.
#pragma once

#include <string>

#include "swarmanoid_interface/registry.hpp"

namespace swarmanoid::program {

/// Returns "from 0 to 1", "one of x, y, z", "true, false", ...
std::string allowedValues(const Parameter& parameter);

}  // namespace swarmanoid::program
