/// "path=value" as it comes from command lines, launch arguments and parameters.
#pragma once

#include <string>
#include <vector>

#include "swarmanoid_space/experiment_file/experiment.hpp"

namespace swarmanoid {

/// The one `path=value` in a text. @param option who gave it, for messages @throws ConfigError
Override parseOverride(const std::string& text, const std::string& option);

/// Several in one text, with blanks between them, as a launch argument has them. A value may hold blanks too, such as
/// "arena.wall.size=1, 2, 2 framework.seed=3": it ends where the next word with a `=` begins.
/// @param option who gave it, for messages @throws ConfigError
std::vector<Override> parseOverrides(const std::string& text, const std::string& option);

}  // namespace swarmanoid
