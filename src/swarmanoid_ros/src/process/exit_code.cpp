#include "exit_code.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <stdexcept>

#include "swarmanoid_interface/process/last_seconds.hpp"

namespace swarmanoid {
namespace {

std::atomic<ExitCode> exit_code{ExitCode::kFinished};

/// Runs after all nodelets are destroyed; only the destructors of static objects are skipped.
void endWithCode() {
  if (exit_code != ExitCode::kFinished) {
    std::fflush(nullptr);
    std::_Exit(toNumber(exit_code));
  }
  endWithinSeconds(ExitCode::kFinished);
}

/// Returns whether replacing the file loses no data.
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

/// Writes a new file that did not exist before, independent of other files beside it.
/// @param name ends with XXXXXX, which is replaced so that the name is new
/// @return whether the whole text is on the disk; otherwise errno gives the reason
bool writeNewFile(std::string& name, const std::string& text) {
  const int file = mkstemp(name.data());
  if (file < 0) {
    return false;
  }
  constexpr mode_t kReadByAll = 0644;  // mkstemp makes it readable for the owner only
  const bool is_written = write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
                          fchmod(file, kReadByAll) == 0 && fsync(file) == 0;
  const int reason = errno;
  const bool is_closed = close(file) == 0;
  if (!is_written) {
    errno = reason;
  }
  return is_written && is_closed;
}

}  // namespace

std::string exitCodeFileOfStarter() {
  const char* name = std::getenv("SWARMANOID_EXIT_CODE");
  return name == nullptr ? "" : name;
}

void setExitCode(ExitCode code) {
  static std::once_flag once;
  std::call_once(once, [] { std::atexit(endWithCode); });
  ExitCode expected = ExitCode::kFinished;
  exit_code.compare_exchange_strong(expected, code);
}

void writeExitCode(const std::string& file, ExitCode code) {
  if (file.empty()) {
    return;
  }
  if (!holdsExitCode(file)) {
    throw std::runtime_error("~exit_code: found '" + file +
                             "', which is there and holds no exit code, allowed: another name");
  }
  const std::string text = std::to_string(toNumber(code)) + '\n';
  std::string unfinished = file + ".XXXXXX";
  if (!writeNewFile(unfinished, text) || std::rename(unfinished.c_str(), file.c_str()) != 0) {
    const int reason = errno;
    unlink(unfinished.c_str());
    throw std::runtime_error("~exit_code: cannot write " + file + ": " + std::strerror(reason));
  }
}

}  // namespace swarmanoid
