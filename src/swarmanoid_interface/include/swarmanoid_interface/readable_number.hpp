/// Numbers in messages to people; numberText (configuration.hpp) has all digits, for files.
#pragma once

#include <string>

namespace swarmanoid {

/// Returns the number with at most three decimals.
std::string readableNumber(double value);

}  // namespace swarmanoid
