/// The version of the suite, for records of runs. The source is written by the build.
#pragma once

#include <string>

namespace swarmanoid {

/// As `swarmanoid --version` has it: "0.1.0+cf9a54f42c1e".
std::string suiteVersion();

}  // namespace swarmanoid
