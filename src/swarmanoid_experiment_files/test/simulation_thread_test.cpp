#include "swarmanoid_space/simulation/simulation_thread.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <stdexcept>
#include <thread>

#include "swarmanoid_experiment_files/testing/small_world.hpp"
#include "swarmanoid_interface/process/user_code_watch.hpp"

namespace swarmanoid {
namespace {

using State = SimulationThread::State;
using Clock = std::chrono::steady_clock;

constexpr int kEndless = 1'000'000'000;

SimulationThread::Options pausedAtFirst() {
  SimulationThread::Options options;
  options.paused = true;
  return options;
}

std::uint64_t tickOf(SimulationThread& thread) {
  std::uint64_t tick = 0;
  thread.look([&](const Simulation& simulation) { tick = simulation.space().tick; });
  return tick;
}

/// @return whether the condition becomes true within a minute, far longer than any machine needs
bool comesTrue(const std::function<bool()>& condition) {
  const auto deadline = Clock::now() + std::chrono::minutes(1);
  while (!condition() && Clock::now() < deadline) {
    std::this_thread::yield();
  }
  return condition();
}

std::string messageOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(SimulationThreadTest, StepsExactlyAsOftenAsItIsTold) {
  SimulationThread thread(test::smallWorld(), pausedAtFirst());
  const auto result = thread.step(7);
  EXPECT_TRUE(result.is_complete);
  EXPECT_EQ(7U, result.tick);
  EXPECT_EQ(kEpoch + std::chrono::milliseconds(700), result.time);
  EXPECT_EQ(7U, tickOf(thread));
  EXPECT_EQ(State::kPaused, thread.state());
}

TEST(SimulationThreadTest, DoesNotStepWhileItRuns) {
  SimulationThread thread(test::smallWorld(kEndless), {});
  const auto result = thread.step(1);
  EXPECT_FALSE(result.is_complete);
  EXPECT_EQ("it is running; pause it first", result.message);
}

TEST(SimulationThreadTest, PauseEndsALongStep) {
  SimulationThread thread(test::smallWorld(kEndless), pausedAtFirst());
  auto step = std::async(std::launch::async, [&] { return thread.step(kEndless); });
  while (tickOf(thread) == 0) {
    std::this_thread::yield();
  }
  EXPECT_EQ("another step is under way", messageOf([&] { thread.step(1); }));
  EXPECT_TRUE(thread.pause());
  EXPECT_EQ("paused before all of them were made", step.get().message);
  const std::uint64_t tick = tickOf(thread);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(tick, tickOf(thread));
}

TEST(SimulationThreadTest, ResumesAndFinishes) {
  std::promise<void> finished;
  bool is_noticed = false;
  auto options = pausedAtFirst();
  options.on_change = [&](const Simulation&, State state, const std::string&) {
    if (state == State::kFinished && !is_noticed) {
      is_noticed = true;
      finished.set_value();
    }
  };
  SimulationThread thread(test::smallWorld(50), options);
  EXPECT_TRUE(thread.resume());
  finished.get_future().get();
  EXPECT_EQ(50U, tickOf(thread));
  EXPECT_EQ("the run is finished; only a reset goes on from here", thread.step(1).message);
  EXPECT_EQ("the run is finished; only a reset goes on from here", messageOf([&] { thread.resume(); }));
}

TEST(SimulationThreadTest, SaysHowFarAStepCameWhenTheRunFinishes) {
  SimulationThread thread(test::smallWorld(50), pausedAtFirst());
  EXPECT_TRUE(thread.step(49).is_complete);
  const auto result = thread.step(2);
  EXPECT_FALSE(result.is_complete);
  EXPECT_EQ(50U, result.tick);
  EXPECT_EQ("the run finished before all of them were made", result.message);
}

TEST(SimulationThreadTest, CompletesTheStepThatReachesTheEnd) {
  SimulationThread thread(test::smallWorld(50), pausedAtFirst());
  EXPECT_TRUE(thread.step(50).is_complete);
  EXPECT_EQ(State::kFinished, thread.state());
}

TEST(SimulationThreadTest, ResetGoesOnWithTimeThatRises) {
  SimulationThread thread(test::smallWorld(50), pausedAtFirst());
  thread.step(50);
  thread.reset(std::nullopt, false);
  EXPECT_EQ(State::kPaused, thread.state());
  EXPECT_EQ(0U, tickOf(thread));
  EXPECT_EQ(kEpoch + std::chrono::milliseconds(5200), thread.step(1).time);
}

TEST(SimulationThreadTest, ResetRewindsTimeWhenAskedTo) {
  SimulationThread thread(test::smallWorld(50), pausedAtFirst());
  thread.step(20);
  thread.reset(3, true);
  EXPECT_EQ(kEpoch + std::chrono::milliseconds(100), thread.step(1).time);
  thread.look([](const Simulation& simulation) { EXPECT_EQ(3U, simulation.space().seed); });
}

TEST(SimulationThreadTest, HandsOnWhatACallThrows) {
  SimulationThread thread(test::smallWorld(), pausedAtFirst());
  EXPECT_EQ("there is no entity 'nobody'",
            messageOf([&] { thread.call([](Simulation& simulation) { simulation.apply(DeleteEntity{"nobody"}); }); }));
  EXPECT_TRUE(thread.step(1).is_complete);
}

TEST(SimulationThreadTest, ReportsChangesButNotLooking) {
  std::atomic<int> changes{0};
  auto options = pausedAtFirst();
  options.on_change = [&](const Simulation&, State, const std::string&) { ++changes; };
  SimulationThread thread(test::smallWorld(), options);
  tickOf(thread);
  const int at_start = changes;
  tickOf(thread);
  EXPECT_EQ(at_start, changes);
  thread.step(3);
  EXPECT_GT(changes, at_start);
}

TEST(SimulationThreadTest, NobodyWaitsForAStoppedRun) {
  SimulationThread thread(test::smallWorld(kEndless), pausedAtFirst());
  auto step = std::async(std::launch::async, [&] { return thread.step(kEndless); });
  while (tickOf(thread) == 0) {
    std::this_thread::yield();
  }
  thread.stop("engine 'ground': its nodelet was unloaded");
  EXPECT_EQ("the run has stopped: engine 'ground': its nodelet was unloaded", step.get().message);
  EXPECT_EQ("the run has stopped: engine 'ground': its nodelet was unloaded", messageOf([&] { thread.pause(); }));
  EXPECT_EQ("engine 'ground': its nodelet was unloaded", thread.stopReason());
}

/// Counts calls of flush, and stores the tick of the last one.
class Flushed final : public Observer {
 public:
  void configure(const std::string&, const Configuration&, const RunContext&) override {}
  void draw(const Space& space) override { drawn_ = space.tick; }
  void flush() override {
    flushed_ = drawn_;
    ++times_;
  }
  std::uint64_t flushed() const { return flushed_; }
  int times() const { return times_; }

 private:
  std::uint64_t drawn_ = 0;
  std::atomic<std::uint64_t> flushed_{0};
  std::atomic<int> times_{0};
};

TEST(SimulationThreadTest, WhatIsWrittenIsHandedOverWhenItPauses) {
  auto simulation = test::smallWorld(kEndless);
  const auto flushed = std::make_shared<Flushed>();
  simulation->addObserver(flushed);
  SimulationThread thread(std::move(simulation), pausedAtFirst());
  thread.step(7);
  EXPECT_TRUE(comesTrue([&] { return flushed->flushed() == 7U; })) << "it is of tick " << flushed->flushed();
}

TEST(SimulationThreadTest, WhatIsWrittenIsHandedOverWhileItRuns) {
  auto simulation = test::smallWorld(kEndless);
  const auto flushed = std::make_shared<Flushed>();
  simulation->addObserver(flushed);
  SimulationThread thread(std::move(simulation), {});
  ASSERT_TRUE(comesTrue([&] { return flushed->times() >= 3; }));
  EXPECT_LT(static_cast<std::uint64_t>(flushed->times()), tickOf(thread)) << "not after each tick";
}

/// Throws in a given tick.
class Thrower final : public Observer {
 public:
  void configure(const std::string&, const Configuration&, const RunContext&) override {}
  void draw(const Space& space) override {
    if (space.tick == 5) {
      throw std::runtime_error("the disk is full");
    }
  }
  void finish() override { *finished = true; }
  std::shared_ptr<bool> finished = std::make_shared<bool>(false);
};

TEST(SimulationThreadTest, ATickThatThrowsStopsTheRunAndKeepsResults) {
  auto simulation = test::smallWorld();
  const auto thrower = std::make_shared<Thrower>();
  simulation->addObserver(thrower);
  SimulationThread thread(std::move(simulation), pausedAtFirst());
  EXPECT_EQ("the run has stopped: tick 5: the disk is full", thread.step(10).message);
  thread.stop("");
  EXPECT_TRUE(*thrower->finished);
}

TEST(SimulationThreadTest, WhoWaitsForUsersCodeThatIsLateIsToldSo) {
  UserCodeWatch::Options quiet;
  quiet.report = [](const std::string&) {};
  const UserCodeWatch watch(quiet);
  SimulationThread thread(test::smallWorld(), pausedAtFirst());
  std::promise<void> end;
  const std::shared_future<void> ended = end.get_future();
  const std::string begin = "busy in init of robot 'fb_9' (controller 'c' of libc.so) since ";
  const auto isBusy = [&](const std::function<void()>& call) { return messageOf(call).rfind(begin, 0) == 0; };
  EXPECT_TRUE(isBusy([&] {
    thread.callUsers([ended](Simulation&) {
      const UserCode init{"init", "controller 'c' of libc.so", "fb_9"};
      const UserCall call(init);
      ended.wait();
    });
  }));
  bool has_acted = false;
  EXPECT_TRUE(isBusy([&] { thread.pause(); }));
  EXPECT_TRUE(isBusy([&] { thread.step(1); }));
  EXPECT_TRUE(isBusy([&] { thread.call([&](Simulation&) { has_acted = true; }); }));
  EXPECT_TRUE(isBusy([&] { thread.reset(std::nullopt, false); }));
  EXPECT_EQ(State::kPaused, thread.state());
  end.set_value();
  EXPECT_EQ(0U, tickOf(thread));
  EXPECT_FALSE(has_acted);
  EXPECT_TRUE(thread.step(1).is_complete);
}

/// Blocks in its first drawing and in finish until it is released.
class Slow final : public Observer {
 public:
  void configure(const std::string&, const Configuration&, const RunContext&) override {}
  void draw(const Space& space) override {
    if (space.tick == 0) {
      drawing.set_value();
      may_draw.get_future().wait();
    }
  }
  void finish() override {
    if (!has_finished_) {
      has_finished_ = true;
      finishing.set_value();
      may_finish.get_future().wait();
    }
  }
  std::promise<void> drawing, may_draw, finishing, may_finish;

 private:
  bool has_finished_ = false;
};

TEST(SimulationThreadTest, WhoAsksWhileAnObserverIsSlowIsAnswered) {
  UserCodeWatch::Options quiet;
  quiet.report = [](const std::string&) {};
  const UserCodeWatch watch(quiet);
  auto simulation = test::smallWorld(50);
  const auto slow = std::make_shared<Slow>();
  simulation->addObserver(slow);
  SimulationThread thread(std::move(simulation), {});
  slow->drawing.get_future().wait();
  EXPECT_EQ(State::kRunning, thread.state());
  EXPECT_EQ(0U, messageOf([&] { thread.pause(); }).rfind("busy in draw of visualisation", 0));
  slow->may_draw.set_value();
  slow->finishing.get_future().wait();
  EXPECT_EQ(State::kFinished, thread.state());
  EXPECT_EQ(0U, messageOf([&] { thread.pause(); }).rfind("busy in finish of visualisation", 0));
  slow->may_finish.set_value();
  EXPECT_EQ(50U, tickOf(thread));
}

TEST(SimulationThreadTest, WhateverATickThrowsStopsTheRun) {
  class NumberThrower final : public Observer {
   public:
    void configure(const std::string&, const Configuration&, const RunContext&) override {}
    void draw(const Space& space) override {
      if (space.tick == 2) {
        throw 7;
      }
    }
  };
  auto simulation = test::smallWorld();
  simulation->addObserver(std::make_shared<NumberThrower>());
  SimulationThread thread(std::move(simulation), pausedAtFirst());
  EXPECT_EQ("the run has stopped: tick 2: visualisation '' threw the number 7, which is no std::exception",
            thread.step(10).message);
}

TEST(SimulationThreadTest, KeepsToTheRealTimeFactor) {
  auto options = pausedAtFirst();
  options.real_time_factor = 2.0;
  SimulationThread thread(test::smallWorld(kEndless, "20"), options);  // 10 ms of wall time per tick
  const auto start = Clock::now();
  thread.resume();
  while (tickOf(thread) < 20) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_GE(Clock::now() - start, std::chrono::milliseconds(185));
}

TEST(SimulationThreadTest, AnotherRealTimeFactorTakesEffectAtOnce) {
  SimulationThread::Options options;
  options.real_time_factor = 1e-6;  // more than a day of wall time for each tick after the first
  SimulationThread thread(test::smallWorld(kEndless), options);
  ASSERT_TRUE(comesTrue([&] { return tickOf(thread) == 1; }));
  thread.setRealTimeFactor(0.0);
  EXPECT_EQ(0.0, thread.realTimeFactor());
  EXPECT_TRUE(comesTrue([&] { return tickOf(thread) > 100; }));
  thread.setRealTimeFactor(2.0);  // 50 ms of wall time per tick
  const std::uint64_t tick = tickOf(thread);
  const auto start = Clock::now();
  ASSERT_TRUE(comesTrue([&] { return tickOf(thread) >= tick + 5; }));
  EXPECT_GE(Clock::now() - start, std::chrono::milliseconds(190)) << "it makes good what nobody asked for";
  thread.reset(std::nullopt, false);
  EXPECT_EQ(2.0, thread.realTimeFactor());
}

}  // namespace
}  // namespace swarmanoid
