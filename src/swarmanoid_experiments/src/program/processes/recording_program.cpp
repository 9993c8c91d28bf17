#include "recording_program.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "become_program.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::program {
namespace {

/// Returns the path of the other program, relative to this one, in a devel space or an install space.
std::string pathOf(const std::string& name) {
  const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe");
  return (own.parent_path().parent_path() / "lib/swarmanoid_recording" / name).string();
}

}  // namespace

void becomeRecordingProgram(const std::string& name, const std::vector<std::string>& arguments) {
  const std::string program = pathOf(name);
  becomeProgram(program, arguments);
  throw ConfigError({program, 0}, std::string("cannot be started: ") + std::strerror(errno));
}

void callRecordingProgram(const std::string& name, const std::vector<std::string>& arguments) {
  const std::string program = pathOf(name);
  const pid_t child = fork();
  if (child < 0) {
    throw ConfigError({program, 0}, std::string("cannot be started: ") + std::strerror(errno));
  }
  if (child == 0) {
    becomeProgram(program, arguments);
    std::cerr << "swarmanoid: " << program << ": cannot be started: " << std::strerror(errno) << std::endl;
    _exit(toNumber(ExitCode::kBadInput));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) {
      throw std::runtime_error(program + ": is lost: " + std::strerror(errno));
    }
  }
  if (!WIFEXITED(status)) {
    throw std::runtime_error(program + ": ended by a signal");
  }
  if (WEXITSTATUS(status) != 0) {
    throw RecordingProgramFailed{static_cast<ExitCode>(WEXITSTATUS(status))};
  }
}

}  // namespace swarmanoid::program
