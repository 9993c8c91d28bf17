// Users' code is held while the process is being ended, and the watch does not depend on the system date.
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <thread>

#include "../src/process/user_calls.hpp"
#include "swarmanoid_interface/process/user_code_watch.hpp"

namespace {

std::atomic<bool> is_calendar_ahead{false};

}  // namespace

/// Replaces the system's function: the calendar can be an hour ahead of the clock that the kernel waits by, as after it
/// was set back.
extern "C" int clock_gettime(clockid_t clock, timespec* time) {
  const auto result = static_cast<int>(syscall(SYS_clock_gettime, clock, time));
  if (clock == CLOCK_REALTIME && is_calendar_ahead) {
    time->tv_sec += 3600;
  }
  return result;
}

namespace swarmanoid {
namespace {

using std::chrono::milliseconds;

constexpr int kWentOn = 77;  // exit code of a thread that should be blocked

const UserCode kStep{"step", "controller 'drive' of libdrive.so", "fb_3", 17};
const char* const kStepText = "step of robot 'fb_3' \\(controller 'drive' of libdrive.so\\), tick 17";

std::uint64_t changes() {
  std::uint64_t all = 0;
  for (const UserCallNote& note : userCallNotes()) {
    all += note.changes;
  }
  return all;
}

TEST(UserCallHoldTest, NobodyEntersOrLeavesUsersCodeUntilItIsTakenBack) {
  std::atomic<bool> is_over{false};
  std::atomic<std::uint64_t> calls{0};
  std::thread caller([&] {
    while (!is_over) {
      const UserCall call(kStep);
      ++calls;
    }
  });
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t before = calls;
    while (calls < before + 3) {  // the thread continues after the last release
      std::this_thread::yield();
    }
    holdUserCalls();
    const std::uint64_t changes_held = changes();
    const std::uint64_t calls_held = calls;
    std::this_thread::sleep_for(milliseconds(2));
    EXPECT_LE(changes(), changes_held + 1);  // the thread is blocked where it counts calls
    EXPECT_LE(calls, calls_held + 1);
    { const UserCall own(kStep); }  // the thread that holds the others is not held
    releaseUserCalls();
  }
  is_over = true;
  caller.join();
}

class UserCallHoldDeathTest : public testing::Test {
 protected:
  UserCallHoldDeathTest() { testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

/// Makes a call of the given duration, and ends the process when it has returned.
void callAndGoOn(double watchdog, milliseconds duration, milliseconds closing_takes) {
  UserCodeWatch watch({nullptr, watchdog});
  const UserCodeWatch::Closing closing(watch, [closing_takes](const UserCodeEnd& end) {
    std::this_thread::sleep_for(closing_takes);
    std::fprintf(stderr, "closed for %s, %d\n", end.robot.c_str(), toNumber(end.exit_code));
  });
  failureOf(kStep, [duration] { std::this_thread::sleep_for(duration); });
  _exit(kWentOn);
}

TEST_F(UserCallHoldDeathTest, ALateCallThatReturnsMeanwhileDoesNotGoOn) {
  const std::string closed = " in " + std::string(kStepText) + "\nclosed for fb_3, 3\n";
  EXPECT_EXIT(callAndGoOn(0.5, milliseconds(2000), milliseconds(4000)), testing::ExitedWithCode(3),
              "watchdog: more than 1 s" + closed);
  EXPECT_EXIT(callAndGoOn(60.0, milliseconds(100), milliseconds(0)), testing::ExitedWithCode(kWentOn), "");
}

TEST_F(UserCallHoldDeathTest, NobodyElseEntersUsersCodeMeanwhile) {
  const auto callFromTwoThreads = [] {
    std::thread other([] {
      std::this_thread::sleep_for(milliseconds(2000));
      failureOf(kStep, [] { _exit(kWentOn); });
    });
    callAndGoOn(0.5, std::chrono::hours(1), milliseconds(4000));
  };
  EXPECT_EXIT(callFromTwoThreads(), testing::ExitedWithCode(3), "closed for fb_3, 3\n");
}

TEST_F(UserCallHoldDeathTest, TheSecondSignalHoldsTooAndIsNotRepeatedForACallThatReturns) {
  const auto endAfter = [](milliseconds duration, milliseconds closing_takes) {
    UserCodeWatch watch({});
    const UserCodeWatch::Closing closing(watch, [closing_takes](const UserCodeEnd&) {
      std::this_thread::sleep_for(closing_takes);
      std::fprintf(stderr, "closed\n");
    });
    UserCodeWatch::askToEndNow();
    failureOf(kStep, [duration] { std::this_thread::sleep_for(duration); });
    _exit(kWentOn);
  };
  EXPECT_EXIT(endAfter(milliseconds(2500), milliseconds(4000)), testing::ExitedWithCode(130), "\nclosed\n");
  EXPECT_EXIT(endAfter(milliseconds(50), milliseconds(0)), testing::ExitedWithCode(kWentOn), "");
}

TEST_F(UserCallHoldDeathTest, TheWatchDoesNotGoByTheCalendar) {
  const auto callUnderAnotherCalendar = [] {
    is_calendar_ahead = true;
    callAndGoOn(0.5, std::chrono::seconds(20), milliseconds(0));
  };
  EXPECT_EXIT(callUnderAnotherCalendar(), testing::ExitedWithCode(3), "watchdog: more than 1 s");
}

}  // namespace
}  // namespace swarmanoid
