#include "swarmanoid_interface/process/last_seconds.hpp"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <string_view>
#include <system_error>
#include <thread>

#include "crash_signals.hpp"

namespace swarmanoid {

namespace {

std::atomic<ExitCode> last_exit_code{ExitCode::kFinished};
static_assert(std::atomic<ExitCode>::is_always_lock_free, "a signal handler reads it");

void onCrash(int signal) {
  const char* name = "";
  for (const CrashSignal& crash : kCrashSignals) {
    name = crash.number == signal ? crash.name : name;
  }
  for (const std::string_view word :
       {std::string_view("swarmanoid: warning: a library crashed ("), std::string_view(name),
        std::string_view(") when all was done: the exit status is that of the work\n")}) {
    [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, word.data(), word.size());
  }
  _exit(toNumber(last_exit_code));
}

/// Handles crashes from here on: the results are complete, so a crash of a library does not change the exit status.
void takeCrashes() {
  // stack of the handler, since the thread's own may be full; that of user_code.cpp is freed before static objects are
  static std::array<char, 64 * 1024> memory;
  stack_t stack{};
  stack.ss_sp = memory.data();
  stack.ss_size = memory.size();
  sigaltstack(&stack, nullptr);
  for (const CrashSignal& crash : kCrashSignals) {
    struct sigaction action {};
    action.sa_handler = onCrash;
    action.sa_flags = SA_ONSTACK;
    sigaction(crash.number, &action, nullptr);
  }
}

}  // namespace

void endWithinSeconds(ExitCode code) {
  last_exit_code = code;
  std::fflush(nullptr);
  takeCrashes();
  try {
    // alarm() is not used: the thread that ends the process may have blocked signals
    std::thread([code] {
      constexpr std::chrono::seconds kPatience{10};
      std::this_thread::sleep_for(kPatience);
      constexpr std::string_view kText = "swarmanoid: a library does not let the process end: it is left there\n";
      [[maybe_unused]] const ssize_t ignored = write(STDERR_FILENO, kText.data(), kText.size());
      _exit(toNumber(code));
    }).detach();
  } catch (const std::system_error&) {
    // the limit is not essential
  }
}

}  // namespace swarmanoid
