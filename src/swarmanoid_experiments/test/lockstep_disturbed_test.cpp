// Actions on a simulation between ticks do not wait for a participant that is late, or never joins.
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <thread>

#include "lockstep_world.hpp"
#include "swarmanoid_space/rule.hpp"
#include "swarmanoid_space/simulation/simulation_thread.hpp"

namespace swarmanoid::test {
namespace {

using namespace std::chrono_literals;

bool disturbed() { return true; }

TEST(LockstepDisturbedTest, ATickThatIsGivenUpLeavesNoTrace) {
  constexpr int kTicks = 150;
  const auto expected = hashesOf(*remoteRetrieval({}), kTicks);
  auto simulation = remoteRetrieval({kEyebot});
  FakeParticipant participant(*simulation, "a", {"eb"});
  participant.is_mute = true;
  participant.join();
  std::vector<std::uint64_t> hashes;
  for (int i = 0; i < kTicks; ++i) {
    const std::uint64_t before = simulation->stateHash();
    EXPECT_FALSE(simulation->tick(disturbed));
    EXPECT_FALSE(simulation->tick(disturbed));
    EXPECT_EQ(before, simulation->stateHash());
    participant.answerLate();
    ASSERT_TRUE(simulation->tick(disturbed)) << "who has answered is not waited for";
    hashes.push_back(simulation->stateHash());
  }
  EXPECT_EQ(expected, hashes);
  EXPECT_EQ(kTicks, participant.frames) << "each tick is asked for once";
  EXPECT_EQ(std::vector<std::string>(kTicks, ""), participant.refusals);
}

TEST(LockstepDisturbedTest, WhatHappensMeanwhileIsAsBetweenTicks) {
  const auto turnAround = [](Simulation& simulation) {
    Pose pose = poseOf(simulation, "fb");
    pose.orientation = Eigen::AngleAxisd(2.1, Eigen::Vector3d::UnitZ());
    simulation.apply(MoveEntity{"fb", pose});
  };
  auto expected = oneRobot("controller");
  hashesOf(*expected, 5);
  turnAround(*expected);
  auto simulation = oneRobot();
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.join();
  hashesOf(*simulation, 5);
  participant.is_mute = true;
  EXPECT_FALSE(simulation->tick(disturbed));
  turnAround(*simulation);
  participant.is_mute = false;
  participant.answerLate();
  EXPECT_EQ(hashesOf(*expected, 10), hashesOf(*simulation, 10));
}

TEST(LockstepDisturbedTest, NobodyWaitsForAParticipantThatHasLostItsRobot) {
  auto simulation = oneRobot();
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.is_mute = true;
  participant.join();
  EXPECT_FALSE(simulation->tick(disturbed));
  simulation->apply(SetCommandSource{"fb", CommandSource::kNone});
  EXPECT_TRUE(simulation->tick(disturbed));
  EXPECT_EQ(1U, simulation->space().tick);
}

TEST(LockstepDisturbedTest, ALateAnswerMaySpeakOfARobotThatWasDeleted) {
  auto simulation = remoteRetrieval({kFootbots});
  FakeParticipant participant(*simulation, "a", {"fb_1", "fb_2", "fb_3"});
  participant.is_mute = true;
  participant.join();
  EXPECT_FALSE(simulation->tick(disturbed));
  simulation->apply(DeleteEntity{"fb_2"});
  participant.answerLate();
  EXPECT_TRUE(simulation->tick());
  participant.is_mute = false;
  EXPECT_TRUE(simulation->tick());
  EXPECT_EQ(std::vector<std::string>{""}, std::vector<std::string>(1, participant.refusals.front()));
  EXPECT_TRUE(simulation->failures().empty());
  EXPECT_EQ(2U, simulation->space().tick);
}

TEST(LockstepDisturbedTest, TheTimeSinceItWasGivenUpIsNotTheParticipants) {
  auto simulation = oneRobot();
  simulation->lockstep().setOptions({LatePolicy::kStop, 2s, 2s});
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.is_mute = true;
  participant.join();
  EXPECT_FALSE(simulation->tick(disturbed));
  std::this_thread::sleep_for(2500ms);  // such as during a pause
  auto answer = std::async(std::launch::async, [&] { participant.answerLate(); });
  EXPECT_TRUE(simulation->tick());
}

/// Counts its calls.
class CountingRule final : public Rule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "counting_rule";
    return description;
  }
  void configure(const Configuration&) override {
    before_ = &addMetric("before", "1", "Calls before ticks.");
    after_ = &addMetric("after", "1", "Calls after ticks.");
  }
  void beforeTick(const Space&, InterventionQueue&) override { before_->value += 1.0; }
  void afterTick(const Space&, InterventionQueue&) override { after_->value += 1.0; }

 private:
  Metric* before_ = nullptr;
  Metric* after_ = nullptr;
};

/// "before, after"
std::string countsOf(const Simulation& simulation) {
  const std::vector<const Metric*>& metrics = simulation.space().metrics;
  return numberText(metrics.at(0)->value) + ", " + numberText(metrics.at(1)->value);
}

TEST(LockstepDisturbedTest, RulesAreAskedOnceForATickHoweverOftenItIsGivenUp) {
  auto simulation = oneRobotBeforeStart("remote", "", "<counting_rule id=\"c\"/>");
  simulation->start();
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.is_mute = true;
  participant.join();
  EXPECT_FALSE(simulation->tick(disturbed));
  EXPECT_FALSE(simulation->tick(disturbed));
  EXPECT_EQ(countsOf(*simulation), "1, 0");
  participant.answerLate();
  EXPECT_TRUE(simulation->tick(disturbed));
  EXPECT_EQ(countsOf(*simulation), "1, 1");
  EXPECT_FALSE(simulation->tick(disturbed));
  EXPECT_EQ(countsOf(*simulation), "2, 1");
  simulation->reset();
  EXPECT_EQ(countsOf(*simulation), "0, 0");
  EXPECT_FALSE(simulation->tick(disturbed));
  EXPECT_EQ(countsOf(*simulation), "1, 0") << "the run that begins asks anew";
}

/// A simulation that waits in its first tick for the participant that commands its robot.
class WaitingThreadTest : public testing::Test {
 protected:
  /// @return whether the action returned
  template <class Action>
  bool getsThrough(Action action) {
    auto done = std::async(std::launch::async, action);
    if (done.wait_for(10s) == std::future_status::ready) {
      done.get();
      return true;
    }
    thread.stop("it hangs");
    return false;
  }

  SimulationThread thread{oneRobotBeforeStart(), {}};
};

TEST_F(WaitingThreadTest, PauseStepResetAndDeleteGetThrough) {
  EXPECT_TRUE(getsThrough([&] { EXPECT_TRUE(thread.pause()); }));
  EXPECT_TRUE(getsThrough([&] { EXPECT_TRUE(thread.resume()); }));
  EXPECT_TRUE(getsThrough([&] { thread.reset(std::nullopt, false); }));
  EXPECT_TRUE(
      getsThrough([&] { thread.look([](const Simulation& simulation) { EXPECT_EQ(0U, simulation.space().tick); }); }));
  EXPECT_TRUE(getsThrough([&] { thread.call([](Simulation& simulation) { simulation.apply(DeleteEntity{"fb"}); }); }));
  while (thread.state() == SimulationThread::State::kRunning) {
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(SimulationThread::State::kFinished, thread.state()) << "without its robot nobody is waited for";
}

TEST_F(WaitingThreadTest, AStepThatWaitsEndsWithAPause) {
  thread.pause();
  auto step = std::async(std::launch::async, [&] { return thread.step(3); });
  while (thread.state() != SimulationThread::State::kStepping) {
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_TRUE(getsThrough([&] { EXPECT_TRUE(thread.pause()); }));
  EXPECT_EQ("paused before all of them were made", step.get().message);
}

TEST_F(WaitingThreadTest, ItsRobotCanBeTakenBack) {
  EXPECT_TRUE(getsThrough([&] {
    thread.call([](Simulation& simulation) { simulation.apply(SetCommandSource{"fb", CommandSource::kController}); });
  }));
  while (thread.state() == SimulationThread::State::kRunning) {
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(SimulationThread::State::kFinished, thread.state());
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_RULE(swarmanoid::test::CountingRule)
