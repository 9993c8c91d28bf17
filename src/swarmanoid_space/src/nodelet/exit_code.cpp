#include "exit_code.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>

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

}  // namespace swarmanoid
