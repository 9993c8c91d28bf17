// `swarmanoid diff`. Bags are read with ROS's library, which this program does not use: it runs another program for
// that.
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <vector>

#include "commands.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::program {
namespace {

/// Returns the path of the other program, beside this one in a devel space as in an install space.
std::filesystem::path diffProgram() {
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe");
  return own.parent_path().parent_path() / "lib/swarmanoid_hosts/diff";
}

ExitCode diff(const std::vector<std::string>& arguments) {
  const std::string program = diffProgram().string();
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) {
    words.push_back(const_cast<char*>(argument.c_str()));  // execv changes nothing, but its type lacks the const
  }
  words.push_back(nullptr);
  execv(words[0], words.data());
  throw ConfigError({program, 0}, std::string("cannot be started: ") + std::strerror(errno));
}

}  // namespace

Command addDiffCommand(CLI::App& app) {
  CLI::App* command = app.add_subcommand("diff", "say in which tick and fields two recorded runs differ");
  command->prefix_command();
  command->set_help_flag();
  return [command] { return diff(command->remaining()); };
}

}  // namespace swarmanoid::program
