/// Identifies the build of the program.
#pragma once

#include <string>

namespace swarmanoid::program {

/// Returns the version of the package and, after a +, the commit that was built: "0.1.0+cf9a54f42c1e". The commit ends
/// in .dirty if files were changed since, and is "unknown" for sources that are not in a git repository.
std::string version();

}  // namespace swarmanoid::program
