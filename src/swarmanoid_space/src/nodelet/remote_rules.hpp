/// What names on the parameter server may mean where other computers reach it: then whoever sets a parameter need not
/// be the user who started this process. What is allowed comes by another way that only this user has, the environment
/// of the process, which launch files set (docs/explanation/security.md).
#pragma once

#include <string>

#include "space_options.hpp"

namespace swarmanoid {

struct RemoteRules {
  bool any_file = true;     ///< as experiment, and to write to
  bool any_library = true;  ///< also those that are not installed
  std::string folder;       ///< files in it are allowed anyway; "": none
};

/// From SWARMANOID_ALLOW_REMOTE_FILES and SWARMANOID_ALLOW_REMOTE_LIBRARIES ("true": allowed), and SWARMANOID_FOLDER.
/// @param is_reachable by other computers; else all is allowed
RemoteRules remoteRules(bool is_reachable);

/// To be asked before anything is written to it; "": there is none, which is allowed. @throws as checkFiles
void checkExitCodeFile(const std::string& file, const RemoteRules& rules);

/// All others. Where not any file is allowed none is replaced either.
/// @throws ConfigError naming the parameter, what was found and what is allowed
void checkFiles(const SpaceOptions& options, const RemoteRules& rules);

}  // namespace swarmanoid
