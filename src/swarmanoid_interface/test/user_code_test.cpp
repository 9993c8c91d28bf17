#include "swarmanoid_interface/process/user_code.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "../src/process/user_calls.hpp"
#include "swarmanoid_interface/process/user_code_watch.hpp"

namespace swarmanoid {
namespace {

const UserCode kStep{"step", "controller 'drive' of libdrive.so", "fb_3", 17};
const char* const kStepText = "step of robot 'fb_3' \\(controller 'drive' of libdrive.so\\), tick 17";

struct Thing {};

std::string failureOfThrowing(const std::function<void()>& action) { return failureOf(kStep, action); }

TEST(UserCodeTest, IsDescribedByWhatThereIs) {
  EXPECT_EQ("step of robot 'fb_3' (controller 'drive' of libdrive.so), tick 17", describe(kStep));
  EXPECT_EQ("init of robot 'fb_3' (controller 'drive')", describe(UserCode{"init", "controller 'drive'", "fb_3"}));
  EXPECT_EQ("loading of library 'drive'", describe(UserCode{"loading", "library 'drive'", ""}));
  EXPECT_EQ("step of robot 'fb_3' (controller 'drive'), tick 0",
            describe(UserCode{"step", "controller 'drive'", "fb_3", 0}));
  EXPECT_EQ("move of engine 'ground' (kinematics2d), tick 17",
            describe(UserCode{"move", "engine 'ground' (kinematics2d)", "", 17, false}));
}

TEST(UserCodeTest, WhateverIsThrownHasAText) {
  const std::string other = ", which is no std::exception";
  EXPECT_EQ("", failureOfThrowing([] {}));
  EXPECT_EQ("told to", failureOfThrowing([] { throw std::runtime_error("told to"); }));
  EXPECT_EQ("threw an exception without a text", failureOfThrowing([] { throw std::runtime_error(""); }));
  EXPECT_EQ("threw the number -7" + other, failureOfThrowing([] { throw -7; }));
  EXPECT_EQ("threw the text 'a text'" + other, failureOfThrowing([] { throw "a text"; }));
  EXPECT_EQ("threw the text 'a string'" + other, failureOfThrowing([] { throw std::string("a string"); }));
  EXPECT_EQ("threw a null pointer" + other, failureOfThrowing([] { throw static_cast<const char*>(nullptr); }));
  EXPECT_EQ("threw a 'swarmanoid::(anonymous namespace)::Thing'" + other, failureOfThrowing([] { throw Thing(); }));
}

TEST(UserCodeTest, OnlyWhatIsNoExceptionIsTurnedIntoOne) {
  EXPECT_EQ(3, callUserCode(kStep, [] { return 3; }));
  EXPECT_THROW(callUserCode(kStep, [] { throw std::out_of_range("far"); }), std::out_of_range);
  EXPECT_THROW(callUserCode(kStep, [] { throw 1; }), std::runtime_error);
}

TEST(UserCodeTest, PluginsThatAreNoControllersAreNotedAndNamed) {
  const std::string part = "engine 'ground' (kinematics2d)";
  EXPECT_EQ(3, callPlugin("move", part, 17, [&] {
              EXPECT_EQ("move of " + part + ", tick 17", describe(ownUserCode()));
              EXPECT_FALSE(ownUserCode().is_controllers);
              return 3;
            }));
  EXPECT_EQ(nullptr, ownUserCode().phase);
  EXPECT_THROW(callPlugin("move", part, 17, [] { throw std::out_of_range("far"); }), std::out_of_range);
  EXPECT_EQ(part + " threw the number 1, which is no std::exception",
            failureOf(kStep, [&] { callPlugin("move", part, 17, [] { throw 1; }); }));
}

TEST(UserCodeTest, TheInnermostCallIsNotedUntilItReturnsOrThrows) {
  EXPECT_EQ(nullptr, ownUserCode().phase);
  {
    const UserCall outer(kStep);
    EXPECT_EQ(describe(kStep), describe(ownUserCode()));
    EXPECT_EQ("threw the number 1, which is no std::exception", failureOf({"init", "inner", ""}, [] {
                EXPECT_STREQ("init", ownUserCode().phase);
                throw 1;
              }));
    EXPECT_EQ(describe(kStep), describe(ownUserCode()));
    std::thread([] { EXPECT_EQ(nullptr, ownUserCode().phase); }).join();
  }
  EXPECT_EQ(nullptr, ownUserCode().phase);
}

TEST(UserCodeTest, ThreadsThatEndGiveTheirNotesBack) {
  for (std::size_t i = 0; i < 2 * kMostUserCallNotes; ++i) {
    std::thread([] {
      const UserCall call(kStep);
      ASSERT_STREQ("step", ownUserCode().phase);
    }).join();
  }
}

TEST(UserCodeTest, TheLibraryOfCodeIsKnown) {
  EXPECT_EQ("libswarmanoid_interface.so", libraryOf(reinterpret_cast<const void*>(&libraryOf)));
  const int on_the_stack = 0;
  EXPECT_EQ("", libraryOf(&on_the_stack));
}

TEST(UserCodeTest, NobodyIsLateWhereNobodyWatches) {
  const UserCall call(kStep);
  EXPECT_EQ("", lateUserCall());
}

TEST(UserCodeTest, ACallIsLateUntilItReturnsAndNoLonger) {
  UserCodeWatch::Options quiet;
  quiet.report = [](const std::string&) {};
  const UserCodeWatch watch(quiet);
  {
    const UserCall call(kStep);
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (lateUserCall().empty() && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::yield();
    }
    EXPECT_EQ(0U, lateUserCall().rfind(describe(kStep) + " since ", 0)) << lateUserCall();
  }
  EXPECT_EQ("", lateUserCall()) << "before the watch looks again";
}

class UserCodeDeathTest : public testing::Test {
 protected:
  UserCodeDeathTest() { testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

void die(const std::function<void()>& call) {
  const UserCodeWatch watch({});
  const UserCodeWatch::Closing closing(const_cast<UserCodeWatch&>(watch), [](const UserCodeEnd& end) {
    std::fprintf(stderr, "closed for %s, %d\n", end.robot.empty() ? end.part.c_str() : end.robot.c_str(),
                 toNumber(end.exit_code));
  });
  call();
}

TEST_F(UserCodeDeathTest, InUsersCodeItIsNamedAndFilesAreClosed) {
  const std::string closed = " in " + std::string(kStepText) + "\nclosed for fb_3, 3\n";
  const auto inStep = [](void (*call)()) { die([call] { failureOf(kStep, call); }); };
  EXPECT_EXIT(inStep([] { raise(SIGSEGV); }), testing::ExitedWithCode(3), "crashed: SIGSEGV" + closed);
  EXPECT_EXIT(inStep([] { std::abort(); }), testing::ExitedWithCode(3), "crashed: SIGABRT" + closed);
  EXPECT_EXIT(inStep([] { std::exit(0); }), testing::ExitedWithCode(3), "called exit" + closed);
  EXPECT_EXIT(inStep([] { std::quick_exit(0); }), testing::ExitedWithCode(3), "called quick_exit" + closed);
}

TEST_F(UserCodeDeathTest, APluginThatIsNoControllerHasAnExitCodeOfItsOwn) {
  const auto inMove = [](void (*call)()) { die([call] { callPlugin("move", "engine 'ground'", 17, call); }); };
  const std::string closed = " in move of engine 'ground', tick 17\nclosed for engine 'ground', 4\n";
  EXPECT_EXIT(inMove([] { raise(SIGSEGV); }), testing::ExitedWithCode(4), "crashed: SIGSEGV" + closed);
  EXPECT_EXIT(inMove([] { std::abort(); }), testing::ExitedWithCode(4), "crashed: SIGABRT" + closed);
  EXPECT_EXIT(inMove([] { std::exit(0); }), testing::ExitedWithCode(4), "called exit" + closed);
}

TEST_F(UserCodeDeathTest, ElsewhereItIsTheSimulator) {
  EXPECT_EXIT(die([] { raise(SIGSEGV); }), testing::KilledBySignal(SIGSEGV), "crashed: SIGSEGV in the simulator");
  EXPECT_EXIT(die([] {
                failureOf(kStep, [] {});
                std::abort();
              }),
              testing::KilledBySignal(SIGABRT), "crashed: SIGABRT in the simulator");
  EXPECT_EXIT(die([] { std::exit(0); }), testing::ExitedWithCode(0), "");
}

TEST_F(UserCodeDeathTest, AClosingThatCrashesIsNoReasonToStay) {
  const auto crashTwice = [] {
    UserCodeWatch watch({});
    const UserCodeWatch::Closing closing(watch, [](const UserCodeEnd&) { raise(SIGSEGV); });
    failureOf(kStep, [] { raise(SIGSEGV); });
  };
  EXPECT_EXIT(crashTwice(), testing::ExitedWithCode(3), "crashed: SIGSEGV while files were completed");
  const auto crashInAnotherPlugin = [] {
    UserCodeWatch watch({nullptr, 0.1});
    const UserCodeWatch::Closing closing(watch, [](const UserCodeEnd&) {
      callPlugin("finish", "visualisation 'table'", UserCode::kNoTick, [] { raise(SIGSEGV); });
    });
    failureOf(kStep, [] { std::this_thread::sleep_for(std::chrono::hours(1)); });
  };
  EXPECT_EXIT(crashInAnotherPlugin(), testing::ExitedWithCode(3), "crashed: SIGSEGV while files were completed");
}

TEST_F(UserCodeDeathTest, WithoutAWatchSignalsAreLeftAlone) {
  EXPECT_EXIT(failureOf(kStep, [] { raise(SIGSEGV); }), testing::KilledBySignal(SIGSEGV), "");
  EXPECT_EXIT(failureOf(kStep, [] { std::exit(5); }), testing::ExitedWithCode(5), "");
}

}  // namespace
}  // namespace swarmanoid
