#include "user_code_end.hpp"

#include <signal.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <mutex>

#include "crash_signals.hpp"
#include "user_calls.hpp"

namespace swarmanoid::user_code_end {
namespace {

std::array<struct sigaction, kCrashSignals.size()> before;
std::atomic<void (*)()> wake_watch{nullptr};
std::atomic<pid_t> watched_process{0};
std::atomic<bool> is_ordered{false};
std::atomic<bool> is_order_ready{false};
std::atomic<bool> is_ending{false};
std::atomic<ExitCode> last_exit_code{ExitCode::kControllerFailed};
static_assert(std::atomic<ExitCode>::is_always_lock_free, "a signal handler reads it");
Order the_order;
__attribute__((tls_model("initial-exec"))) thread_local bool is_watch = false;

/// Writes all words in one call, if possible. Inaccessible memory does not crash: the kernel refuses the write.
void say(std::initializer_list<std::string_view> words) {
  std::array<iovec, 16> pieces{};
  int count = 0;
  for (const std::string_view word : words) {
    pieces[static_cast<std::size_t>(count++)] = {const_cast<char*>(word.data()), word.size()};
  }
  if (writev(STDERR_FILENO, pieces.data(), count) < 0) {
    constexpr std::string_view kLess = "swarmanoid: users' code has failed, and its name is lost\n";
    [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, kLess.data(), kLess.size());
  }
}

/// Writes the text of describe().
void say(const char* ending, const UserCode& code) {
  std::array<char, 21> digits{};
  std::size_t first = digits.size();
  for (std::uint64_t rest = code.tick; first == digits.size() || rest > 0; rest /= 10) {
    digits[--first] = static_cast<char>('0' + rest % 10);
  }
  const bool has_robot = !code.robot.empty();
  const bool has_tick = code.tick != UserCode::kNoTick;
  say({"swarmanoid: ", ending, " in ", code.phase, " of ", has_robot ? "robot '" : "", code.robot,
       has_robot ? "' (" : "", code.part, has_robot ? ")" : "", has_tick ? ", tick " : "",
       has_tick ? std::string_view(&digits[first], digits.size() - first) : "", "\n"});
}

bool isWatchedProcess() { return getpid() == watched_process; }  // excludes children made by fork

[[noreturn]] void standStill() {
  for (;;) {
    constexpr timespec kLong{3600, 0};
    nanosleep(&kLong, nullptr);
  }
}

[[noreturn]] void order(const char* ending, const UserCode& code) {
  if (!is_ordered.exchange(true)) {
    say(ending, code);
    the_order = {ending, code};
    is_order_ready = true;
    endSoon(exitCodeOf(code));
    if (const auto wake = wake_watch.load()) {
      wake();
    } else {
      _exit(toNumber(exitCodeOf(code)));
    }
  }
  standStill();
}

void endByDefault(int signal) {
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  sigaction(signal, &action, nullptr);
  raise(signal);  // the signal is delivered when the handler returns
}

/// Ends the process if this is the watch's thread, which runs users' code only while it completes files.
void endClosing(const char* ending) {
  if (is_watch && is_ending) {
    say({"swarmanoid: ", ending, " while files were completed\n"});
    _exit(toNumber(last_exit_code));
  }
}

void onCrash(int signal) {
  const char* ending = "";
  for (const CrashSignal& crash : kCrashSignals) {
    ending = crash.number == signal ? crash.ending : ending;
  }
  const UserCode code = ownUserCode();
  if (!isWatchedProcess()) {
    endByDefault(signal);
    return;
  }
  endClosing(ending);
  if (code.phase == nullptr) {
    say({"swarmanoid: ", ending, " in the simulator (this thread is not in users' code)\n"});
    endByDefault(signal);
  } else {
    order(ending, code);
  }
}

void onExit(const char* ending) {
  const UserCode code = ownUserCode();
  if (code.phase != nullptr && isWatchedProcess()) {
    endClosing(ending);
    order(ending, code);
  }
}

void onLastResort(int) { _exit(toNumber(last_exit_code)); }

}  // namespace

void install(void (*wake)()) {
  static std::once_flag once;
  std::call_once(once, [] { std::at_quick_exit([] { onExit("called quick_exit"); }); });
  wake_watch = wake;
  watched_process = getpid();
  setUserCodeEnder(onExit);
  for (std::size_t i = 0; i < kCrashSignals.size(); ++i) {
    struct sigaction action {};
    action.sa_handler = onCrash;
    action.sa_flags = SA_ONSTACK;
    sigaction(kCrashSignals[i].number, &action, &before[i]);
  }
}

void uninstall() {
  for (std::size_t i = 0; i < kCrashSignals.size(); ++i) {
    sigaction(kCrashSignals[i].number, &before[i], nullptr);
  }
  setUserCodeEnder(nullptr);
  watched_process = 0;
  wake_watch = nullptr;
}

void beWatch() { is_watch = true; }

const Order* order() { return is_order_ready ? &the_order : nullptr; }

void endSoon(ExitCode exit_code) {
  last_exit_code = exit_code;
  is_ending = true;
  struct sigaction action {};
  action.sa_handler = onLastResort;
  sigaction(SIGALRM, &action, nullptr);
  constexpr unsigned kPatience = 10;  // [s]
  alarm(kPatience);
}

}  // namespace swarmanoid::user_code_end
