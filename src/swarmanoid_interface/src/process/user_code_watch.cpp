#include "swarmanoid_interface/process/user_code_watch.hpp"

#include <fcntl.h>
#include <semaphore.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <vector>

#include "user_calls.hpp"
#include "user_code_end.hpp"

namespace swarmanoid {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLate = 5.0;          // [s] until a call is reported
constexpr double kAgain = 30.0;        // [s] until it is reported again
constexpr double kStuck = 0.4;         // [s] after which a call counts as stuck when the end is requested
constexpr double kEndsByItself = 5.0;  // [s] for a process outside users' code whose end is requested

sem_t wake;
std::atomic<int> ends_asked_for{0};
std::atomic<bool> is_watched{false};

std::string secondsText(double seconds) { return std::to_string(std::lround(seconds)) + " s"; }

/// Reads memory that may be unmapped, through the kernel, which returns an error where a pointer would crash.
class CarefulReader {
 public:
  CarefulReader() {
    if (pipe2(pipe_, O_CLOEXEC | O_NONBLOCK) != 0) {
      pipe_[0] = pipe_[1] = -1;
    }
  }
  ~CarefulReader() {
    close(pipe_[0]);
    close(pipe_[1]);
  }
  CarefulReader(const CarefulReader&) = delete;
  CarefulReader& operator=(const CarefulReader&) = delete;

  std::string read(const char* data, std::size_t size) const {
    std::string text(std::min<std::size_t>(size, 500), '\0');
    const ssize_t written = text.empty() ? 0 : ::write(pipe_[1], data, text.size());
    const ssize_t got = written > 0 ? ::read(pipe_[0], text.data(), static_cast<std::size_t>(written)) : 0;
    text.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return text;
  }

 private:
  int pipe_[2] = {-1, -1};
};

/// The state of one note at its last reading.
struct Sight {
  std::uint64_t changes = 0;
  double seconds = 0.0;        ///< duration of the call that is under way
  double next_report = kLate;  ///< [s]
};

struct OwnedCode {
  std::string part;
  std::string robot;
  UserCode code;  ///< refers to the texts
};

static_assert(std::is_trivially_copyable_v<UserCode>, "it is read from another thread's stack");

struct LateCall {
  std::string text;
  double seconds = 0.0;
  std::size_t note = 0;
  std::uint64_t changes = 0;  ///< of that note

  bool isOver() const { return userCallNotes()[note].changes.load(std::memory_order_acquire) != changes; }
};

class Watch {
 public:
  explicit Watch(UserCodeWatch::Options options) : options_(std::move(options)), sights_(kMostUserCallNotes) {
    user_code_end::install([] { sem_post(&wake); });
    thread_ = std::thread([this] { run(); });
  }
  ~Watch() {
    is_over_ = true;
    sem_post(&wake);
    thread_.join();
    user_code_end::uninstall();
  }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  std::uint64_t addClosing(std::function<void(const UserCodeEnd&)> close) {
    const std::lock_guard<std::mutex> lock(closings_mutex_);
    closings_.emplace(++last_closing_, std::move(close));
    return last_closing_;
  }
  void removeClosing(std::uint64_t number) {
    const std::lock_guard<std::mutex> lock(closings_mutex_);
    closings_.erase(number);
  }

  std::optional<LateCall> late() const {
    const std::lock_guard<std::mutex> lock(late_mutex_);
    return late_ && !late_->isOver() ? late_ : std::nullopt;  // it may have returned since it was read
  }

 private:
  void run();
  void lookAt(std::size_t i, double passed, std::optional<LateCall>& latest);
  void look(double passed);
  bool copy(const UserCallNote& note, const Sight& sight, OwnedCode& code) const;
  void report(const std::string& text) const;
  bool holdUnlessOver(std::size_t i) const;
  void serveAsked(double passed);
  [[noreturn]] void endWith(const std::string& ending, const UserCode* code, ExitCode exit_code);

  UserCodeWatch::Options options_;
  CarefulReader reader_;
  std::vector<Sight> sights_;  // in the order of the notes
  double asked_seconds_ = 0.0;
  std::mutex closings_mutex_;
  std::map<std::uint64_t, std::function<void(const UserCodeEnd&)>> closings_;
  std::uint64_t last_closing_ = 0;
  mutable std::mutex late_mutex_;
  std::optional<LateCall> late_;
  std::atomic<bool> is_over_{false};
  std::thread thread_;
};

std::mutex the_watch_mutex;
std::unique_ptr<Watch> the_watch;
int watch_count = 0;

void Watch::run() {
  user_code_end::beWatch();
  auto last = Clock::now();
  while (!is_over_) {
    timespec until{};
    clock_gettime(CLOCK_MONOTONIC, &until);
    constexpr long kInterval = 200'000'000;  // [ns]
    constexpr long kSecond = 1'000'000'000;
    until.tv_nsec += kInterval;
    until.tv_sec += until.tv_nsec / kSecond;
    until.tv_nsec %= kSecond;
    sem_clockwait(&wake, CLOCK_MONOTONIC, &until);
    if (const user_code_end::Order* order = user_code_end::order()) {
      holdUserCalls();
      endWith(order->ending, &order->code, user_code_end::exitCodeOf(order->code));
    }
    const auto now = Clock::now();
    // limits the time that counts if the process was stopped meanwhile
    const double passed = std::min(1.0, std::chrono::duration<double>(now - last).count());
    last = now;
    look(passed);
    if (ends_asked_for > 0) {
      serveAsked(passed);
    }
  }
}

void Watch::look(double passed) {
  std::optional<LateCall> latest;
  for (std::size_t i = 0; i < sights_.size(); ++i) {
    lookAt(i, passed, latest);
  }
  const std::lock_guard<std::mutex> lock(late_mutex_);
  late_ = std::move(latest);
}

void Watch::lookAt(std::size_t i, double passed, std::optional<LateCall>& latest) {
  const UserCallNote& note = userCallNotes()[i];
  Sight& sight = sights_[i];
  const std::uint64_t changes = note.changes.load(std::memory_order_acquire);
  if (changes != sight.changes || note.call.load() == nullptr) {
    sight = Sight{};
    sight.changes = changes;
    return;
  }
  sight.seconds += passed;
  OwnedCode owned;
  const bool is_watchdog_due = options_.watchdog > 0.0 && sight.seconds >= options_.watchdog;
  if ((sight.seconds < kLate && !is_watchdog_due) || !copy(note, sight, owned)) {
    return;
  }
  const std::string text = describe(owned.code);
  if (sight.seconds >= sight.next_report) {
    report("late: " + text + " has taken " + secondsText(sight.seconds) + " so far");
    sight.next_report = sight.seconds + kAgain;
  }
  if (sight.seconds >= kLate && (!latest || sight.seconds > latest->seconds)) {
    latest = LateCall{text, sight.seconds, i, changes};
  }
  if (is_watchdog_due && holdUnlessOver(i)) {
    endWith("watchdog: more than " + secondsText(options_.watchdog), &owned.code,
            user_code_end::exitCodeOf(owned.code));
  }
}

/// @return false if the call is over, so that the texts may be those of the next call
bool Watch::copy(const UserCallNote& note, const Sight& sight, OwnedCode& owned) const {
  const auto is_over = [&] { return note.changes.load(std::memory_order_acquire) != sight.changes; };
  const std::string bytes = reader_.read(reinterpret_cast<const char*>(note.call.load()), sizeof(UserCode));
  if (bytes.size() != sizeof(UserCode) || is_over()) {
    return false;
  }
  std::memcpy(&owned.code, bytes.data(), sizeof(UserCode));
  owned.part = reader_.read(owned.code.part.data(), owned.code.part.size());
  owned.robot = reader_.read(owned.code.robot.data(), owned.code.robot.size());
  owned.code.part = owned.part;
  owned.code.robot = owned.robot;
  return !is_over();
}

/// Holds all users' code, so that no other thread uses the objects that are being closed.
/// @return false if the call has ended meanwhile; then all threads continue
bool Watch::holdUnlessOver(std::size_t i) const {
  holdUserCalls();
  const bool is_over = userCallNotes()[i].changes.load(std::memory_order_acquire) != sights_[i].changes;
  if (is_over) {
    releaseUserCalls();
  }
  return !is_over;
}

void Watch::report(const std::string& text) const {
  if (options_.report) {
    options_.report(text);
  } else {
    std::fprintf(stderr, "swarmanoid: %s\n", text.c_str());
  }
}

void Watch::serveAsked(double passed) {
  asked_seconds_ += passed;
  const bool is_over = asked_seconds_ >= kEndsByItself;
  for (std::size_t i = 0; i < sights_.size(); ++i) {
    OwnedCode owned;
    if (sights_[i].seconds >= kStuck && copy(userCallNotes()[i], sights_[i], owned) &&
        (owned.code.is_controllers || is_over) && holdUnlessOver(i)) {
      endWith("interrupted", &owned.code, ExitCode::kInterrupted);
    }
  }
  if (is_over) {
    std::fprintf(stderr, "swarmanoid: interrupted again; does not end by itself\n");
    endWith("interrupted", nullptr, ExitCode::kInterrupted);
  }
}

void Watch::endWith(const std::string& ending, const UserCode* code, ExitCode exit_code) {
  user_code_end::endSoon(exit_code);
  const std::string reason = code == nullptr ? ending : ending + " in " + describe(*code);
  if (user_code_end::order() == nullptr && code != nullptr) {
    std::fprintf(stderr, "swarmanoid: %s\n", reason.c_str());
  }
  if (code != nullptr) {  // otherwise other threads may use the objects to be closed
    const std::lock_guard<std::mutex> lock(closings_mutex_);
    for (const auto& [number, close] : closings_) {
      try {
        close({std::string(code->robot), std::string(code->part), reason, exit_code});
      } catch (...) {
        std::fprintf(stderr, "swarmanoid: %s\n", describeException().c_str());
      }
    }
  }
  std::fflush(stdout);
  _exit(toNumber(exit_code));
}

}  // namespace

UserCodeWatch::UserCodeWatch(Options options) {
  const std::lock_guard<std::mutex> lock(the_watch_mutex);
  static std::once_flag once;
  std::call_once(once, [] { sem_init(&wake, 0, 0); });
  if (++watch_count == 1) {
    the_watch = std::make_unique<Watch>(std::move(options));
    is_watched = true;
  }
}

UserCodeWatch::~UserCodeWatch() {
  const std::lock_guard<std::mutex> lock(the_watch_mutex);
  if (--watch_count == 0) {
    is_watched = false;
    the_watch.reset();
  }
}

UserCodeWatch::Closing::Closing(UserCodeWatch&, std::function<void(const UserCodeEnd&)> close)
    : number_(the_watch->addClosing(std::move(close))) {}

UserCodeWatch::Closing::~Closing() { the_watch->removeClosing(number_); }

void UserCodeWatch::askToEndNow() {
  if (++ends_asked_for > 1 || !is_watched) {
    _exit(toNumber(ExitCode::kInterrupted));
  }
  sem_post(&wake);
}

std::string lateUserCall() {
  const std::lock_guard<std::mutex> lock(the_watch_mutex);
  const auto late = the_watch == nullptr ? std::nullopt : the_watch->late();
  return late ? late->text + " since " + secondsText(late->seconds) : "";
}

}  // namespace swarmanoid
