/// Commands that other packages bring, in any language: `swarmanoid batch` is the program `swarmanoid-batch`, beside
/// this one or else in a folder of PATH, as git has it. A script says what it does in one of its first lines, for
/// --help:
/// "# summary: runs an experiment with many seeds".
#pragma once

#include <string>
#include <vector>

namespace swarmanoid::program {

struct ExternalCommand {
  std::string name;     ///< "batch"
  std::string program;  ///< its file
  std::string summary;  ///< "" if it does not say
};

/// Returns those that can be started, sorted by name; of two with one name, that which PATH has first.
std::vector<ExternalCommand> externalCommands();

/// Replaces this process by the command. @throws ConfigError if it cannot be started
[[noreturn]] void becomeExternalCommand(const ExternalCommand& command, const std::vector<std::string>& arguments);

}  // namespace swarmanoid::program
