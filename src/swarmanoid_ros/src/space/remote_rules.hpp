/// Restricts the file and library names on the parameter server if other computers can reach it: then any user who can
/// reach it may set a parameter, not only the user who started this process. Exceptions come from the environment of
/// the process, which launch files set and only this user can change (docs/explanation/security.md).
#pragma once

#include <string>

#include "space_options.hpp"

namespace swarmanoid {

struct RemoteRules {
  bool any_file = true;     ///< any file is allowed, as experiment and to write to
  bool any_library = true;  ///< libraries that are not installed are allowed too
  std::string folder;       ///< files in this folder are always allowed; "": none
};

/// Reads SWARMANOID_ALLOW_REMOTE_FILES and SWARMANOID_ALLOW_REMOTE_LIBRARIES ("true": allowed), and SWARMANOID_FOLDER.
/// @param is_reachable by other computers; otherwise all is allowed
RemoteRules remoteRules(bool is_reachable);

/// Checks the file before anything is written to it; "" means no file, which is allowed. @throws as checkFiles
void checkExitCodeFile(const std::string& file, const RemoteRules& rules);

/// Checks all other files. If files are restricted, no existing file is replaced either.
/// @throws ConfigError naming the parameter, the value found and the allowed values
void checkFiles(const SpaceOptions& options, const RemoteRules& rules);

}  // namespace swarmanoid
