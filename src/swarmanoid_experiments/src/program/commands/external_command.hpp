/// Commands that other packages provide, in any language: `swarmanoid batch` starts the program `swarmanoid-batch`,
/// from the folder of this program or from a folder of PATH, as git does. A script describes itself in one of its first
/// lines, for --help:
/// "# summary: runs an experiment with many seeds".
#pragma once

#include <string>
#include <vector>

namespace swarmanoid::program {

struct ExternalCommand {
  std::string name;     ///< "batch"
  std::string program;  ///< path of its file
  std::string summary;  ///< "" if it has none
};

/// Returns the executable commands, sorted by name; for equal names, the first one in PATH.
std::vector<ExternalCommand> externalCommands();

/// Replaces this process by the command. @throws ConfigError if it cannot be started
[[noreturn]] void becomeExternalCommand(const ExternalCommand& command, const std::vector<std::string>& arguments);

}  // namespace swarmanoid::program
