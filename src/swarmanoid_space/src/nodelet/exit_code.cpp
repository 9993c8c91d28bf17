#include "exit_code.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <stdexcept>

namespace swarmanoid {
namespace {

std::atomic<int> exit_code{0};

/// All nodelets are gone by now; what is left out are destructors of static objects.
void endWithCode() {
  if (exit_code != 0) {
    std::fflush(nullptr);
    std::_Exit(exit_code);
  }
}

}  // namespace

void setExitCode(ExitCode code) {
  static std::once_flag once;
  std::call_once(once, [] { std::atexit(endWithCode); });
  int expected = 0;
  exit_code.compare_exchange_strong(expected, static_cast<int>(code));
}

void writeExitCode(const std::string& file, ExitCode code) {
  if (file.empty()) {
    return;
  }
  const std::string unfinished = file + ".new";
  {
    std::ofstream out(unfinished);
    out << static_cast<int>(code) << '\n';
  }
  std::error_code problem;
  std::filesystem::rename(unfinished, file, problem);
  if (problem) {
    throw std::runtime_error("~exit_code: cannot write " + file + ": " + problem.message());
  }
}

}  // namespace swarmanoid
