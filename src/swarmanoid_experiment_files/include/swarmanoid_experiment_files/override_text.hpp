/// "path=value" from command lines, launch arguments and parameters.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/experiment/experiment.hpp"

namespace swarmanoid {

/// The one `path=value` in a text. @param option its source, for messages @throws ConfigError
Override parseOverride(const std::string& text, const std::string& option);

/// Several `path=value` in one text, separated by blanks, as in a launch argument. A value may contain blanks too, such
/// as "arena.wall.size=1, 2, 2 framework.seed=3": it ends where the next word with a `=` begins.
/// @param option its source, for messages @throws ConfigError
std::vector<Override> parseOverrides(const std::string& text, const std::string& option);

}  // namespace swarmanoid
