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

/// Whether nothing is lost if the file is replaced.
bool holdsExitCode(const std::filesystem::path& file) {
  std::error_code ignored;
  const auto status = std::filesystem::symlink_status(file, ignored);
  if (!std::filesystem::exists(status)) {
    return true;
  }
  constexpr std::size_t kLongest = 4;  // "130", and the end of the line
  std::ifstream in(file);
  std::string text(kLongest + 1, ' ');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return std::filesystem::is_regular_file(status) && text.size() <= kLongest &&
         text.find_first_not_of("0123456789\n") == std::string::npos;
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
  if (!holdsExitCode(file)) {
    throw std::runtime_error("~exit_code: found '" + file +
                             "', which is there and holds no exit code, allowed: another name");
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
