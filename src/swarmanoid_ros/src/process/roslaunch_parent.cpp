#include "roslaunch_parent.hpp"

#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace swarmanoid {
namespace {

/// Recognises a script: the interpreter is the first argument, the script itself the second.
bool isRoslaunch(pid_t process) {
  std::ifstream command("/proc/" + std::to_string(process) + "/cmdline", std::ios::binary);
  std::string word;
  for (int i = 0; i < 2 && std::getline(command, word, '\0'); ++i) {
    if (std::filesystem::path(word).filename() == "roslaunch") {
      return true;
    }
  }
  return false;
}

}  // namespace

bool interruptRoslaunch() {
  const pid_t parent = getppid();
  return isRoslaunch(parent) && kill(parent, SIGINT) == 0;
}

}  // namespace swarmanoid
