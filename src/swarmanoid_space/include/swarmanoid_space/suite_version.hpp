/// Identifies the build of the suite. The source is written by the build.
#pragma once

#include <string>

namespace swarmanoid {

/// The version of the packages and, after a +, the commit that was built: "0.1.0+cf9a54f42c1e". The commit ends in
/// .dirty if files were changed since, and is "unknown" for sources that are not in a git repository.
std::string suiteVersion();

}  // namespace swarmanoid
