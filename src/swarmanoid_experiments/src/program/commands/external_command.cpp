#include "external_command.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string_view>

#include "../processes/become_program.hpp"
#include "swarmanoid_interface/configuration.hpp"

namespace swarmanoid::program {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = "swarmanoid-";

std::vector<fs::path> foldersOfPrograms() {
  std::error_code error;
  std::vector<fs::path> folders{fs::read_symlink("/proc/self/exe", error).parent_path()};
  const char* const path = std::getenv("PATH");
  std::istringstream words(path == nullptr ? "" : path);
  for (std::string folder; std::getline(words, folder, ':');) {
    if (!folder.empty()) {
      folders.emplace_back(folder);
    }
  }
  return folders;
}

/// Returns the summary line of a script; "" for other programs.
std::string summaryIn(const fs::path& program) {
  constexpr std::string_view kMark = "# summary: ";
  constexpr int kFirstLines = 5;
  std::ifstream file(program);
  std::string line;
  for (int i = 0; i < kFirstLines && std::getline(file, line); ++i) {
    if (i == 0 && line.rfind("#!", 0) != 0) {
      return "";
    }
    if (line.rfind(kMark, 0) == 0) {
      return line.substr(kMark.size());
    }
  }
  return "";
}

bool isProgram(const fs::directory_entry& entry) {
  std::error_code error;
  return entry.is_regular_file(error) && access(entry.path().c_str(), X_OK) == 0;
}

}  // namespace

std::vector<ExternalCommand> externalCommands() {
  std::map<std::string, ExternalCommand> found;
  for (const fs::path& folder : foldersOfPrograms()) {
    std::error_code error;  // folders of PATH may be missing
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      const std::string file = entry.path().filename().string();
      if (file.rfind(kPrefix, 0) == 0 && file.size() > kPrefix.size() && isProgram(entry)) {
        const std::string name = file.substr(kPrefix.size());
        if (found.count(name) == 0) {
          found[name] = {name, entry.path().string(), summaryIn(entry.path())};
        }
      }
    }
  }
  std::vector<ExternalCommand> commands;
  for (const auto& [name, command] : found) {
    commands.push_back(command);
  }
  return commands;
}

void becomeExternalCommand(const ExternalCommand& command, const std::vector<std::string>& arguments) {
  becomeProgram(command.program, arguments);
  throw ConfigError({command.program, 0}, std::string("cannot be started: ") + std::strerror(errno));
}

}  // namespace swarmanoid::program
