#include "second_signal.hpp"

#include <signal.h>

#include <array>
#include <atomic>
#include <mutex>

#include "swarmanoid_interface/process/user_code_watch.hpp"

namespace swarmanoid {
namespace {

constexpr std::array<int, 2> kSignals{SIGINT, SIGTERM};
std::array<struct sigaction, kSignals.size()> before;
std::atomic<bool> has_come{false};

void answerAsBefore(int signal, siginfo_t* info, void* context) {
  const struct sigaction& old = before[signal == kSignals[0] ? 0 : 1];
  if ((old.sa_flags & SA_SIGINFO) != 0) {
    old.sa_sigaction(signal, info, context);
  } else if (old.sa_handler == SIG_DFL) {
    sigaction(signal, &old, nullptr);
    raise(signal);
  } else if (old.sa_handler != SIG_IGN) {
    old.sa_handler(signal);
  }
}

void take(int signal, siginfo_t* info, void* context) {
  if (has_come.exchange(true)) {
    UserCodeWatch::askToEndNow();
  } else {
    answerAsBefore(signal, info, context);
  }
}

}  // namespace

void passOnSecondSignal() {
  static std::once_flag once;
  std::call_once(once, [] {
    struct sigaction action {};
    action.sa_sigaction = take;
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
      sigaction(kSignals[i], &action, &before[i]);
    }
  });
}

}  // namespace swarmanoid
