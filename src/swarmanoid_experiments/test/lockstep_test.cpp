// Robots with controllers in another process: a participant in this process simulates it, and answers as configured.
#include "swarmanoid_space/lockstep/lockstep.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "lockstep_world.hpp"

namespace swarmanoid::test {
namespace {

using namespace std::chrono_literals;

void setOptions(Simulation& simulation, LatePolicy policy, Lockstep::Seconds timeout = 20ms) {
  simulation.lockstep().setOptions({policy, timeout, timeout});
}

std::vector<std::uint64_t> expectedHashes() { return hashesOf(*remoteRetrieval({}), 400); }

TEST(LockstepTest, AllElsewhereGivesTheSameBits) {
  auto simulation = remoteRetrieval({kFootbots, kEyebot});
  FakeParticipant first(*simulation, "a", {"fb_1"});
  FakeParticipant second(*simulation, "b", {"fb_2"});
  FakeParticipant third(*simulation, "c", {"fb_3"});
  FakeParticipant fourth(*simulation, "d", {"eb"});
  for (FakeParticipant* participant : {&first, &second, &third, &fourth}) {
    participant->join();
  }
  EXPECT_EQ(expectedHashes(), hashesOf(*simulation, 400));
  EXPECT_EQ(400, first.frames);
}

TEST(LockstepTest, SomeElsewhereGiveTheSameBits) {
  auto simulation = remoteRetrieval({kFootbots}, 2);
  FakeParticipant participant(*simulation, "a", {"fb_3", "fb_1", "fb_2"});
  participant.join();
  EXPECT_EQ(expectedHashes(), hashesOf(*simulation, 400));
}

TEST(LockstepTest, AResetStartsControllersElsewhereAnewToo) {
  auto simulation = remoteRetrieval({kEyebot});
  FakeParticipant participant(*simulation, "a", {"eb"});
  participant.join();
  const auto expected = hashesOf(*simulation, 100);
  simulation->reset();
  EXPECT_EQ(expected, hashesOf(*simulation, 100));
  simulation->reset(8);
  EXPECT_EQ(hashesOf(*remoteRetrieval({}, 1, 8), 100), hashesOf(*simulation, 100));
}

double xOf(const Simulation& simulation) { return poseOf(simulation, "fb").position.x(); }

TEST(LockstepTest, WaitsForWhoIsLateAndNamesIt) {
  auto simulation = oneRobot();
  setOptions(*simulation, LatePolicy::kWait);
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.join();
  simulation->tick();
  participant.is_mute = true;
  std::string logged;
  simulation->setLogSink(
      [&](LogLevel, const std::string& who, const std::string& text) { logged += who + ": " + text; });
  std::thread late([&] {
    while (!simulation->lockstep().reports().front().is_late) {
      std::this_thread::sleep_for(1ms);
    }
    participant.is_mute = false;
    participant.join();  // like a process that died and was restarted
  });
  simulation->tick();
  late.join();
  EXPECT_EQ(std::vector<std::string>{"a: no answer in tick 1 (0.02 s); policy wait"},
            textsOf(*simulation, Event::Kind::kParticipantLate));
  EXPECT_EQ(std::vector<std::string>{"a: again, for fb"}, textsOf(*simulation, Event::Kind::kParticipantJoined));
  EXPECT_NE(std::string::npos, logged.find("participant 'a': no answer in tick 1"));
  EXPECT_FALSE(simulation->lockstep().reports().front().is_late);
  auto in_process = oneRobot("controller");
  EXPECT_EQ(hashesOf(*in_process, 3).back(), hashesOf(*simulation, 1).back());
}

TEST(LockstepTest, SkipsWhoIsLateUntilItAnswers) {
  auto simulation = oneRobot();
  setOptions(*simulation, LatePolicy::kSkip);
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.join();
  simulation->tick();
  participant.is_mute = true;
  const auto start = std::chrono::steady_clock::now();
  simulation->tick();
  EXPECT_EQ(std::vector<std::string>{"a: no answer in tick 1 (0.02 s); policy skip"},
            textsOf(*simulation, Event::Kind::kParticipantLate));
  for (int i = 0; i < 60; ++i) {
    simulation->tick();
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, 1s) << "each tick waits";
  EXPECT_GT(xOf(*simulation), 1.5) << "the last command is kept";
  participant.is_mute = false;
  simulation->tick();
  simulation->tick();
  EXPECT_FALSE(simulation->lockstep().reports().front().is_late);
  EXPECT_EQ(1U, simulation->lockstep().reports().front().times_late);
}

TEST(LockstepTest, StopsIfAskedTo) {
  auto simulation = oneRobot();
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.policy = LatePolicy::kStop;
  participant.timeout = 20ms;
  participant.join();
  simulation->tick();
  participant.is_mute = true;
  try {
    simulation->tick();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ("participant 'a': no answer in tick 1 (0.02 s); policy stop", error.what());
  }
}

TEST(LockstepTest, NamesRobotsThatNobodyCommands) {
  auto simulation = oneRobot();
  setOptions(*simulation, LatePolicy::kSkip);
  simulation->tick();
  EXPECT_EQ(std::vector<std::string>{": no participant has registered for fb in tick 0 (0.02 s); policy skip"},
            textsOf(*simulation, Event::Kind::kParticipantLate));
  EXPECT_EQ("fb", simulation->lockstep().reports().front().robots.front());
  setOptions(*simulation, LatePolicy::kStop);
  simulation->reset();
  EXPECT_THROW(simulation->tick(), std::runtime_error);
}

TEST(LockstepTest, WhoWasNamedIsNotWaitedForAgainBecauseAnotherGoes) {
  auto simulation = remoteRetrieval({kFootbots});
  simulation->lockstep().setOptions({LatePolicy::kSkip, Lockstep::Seconds(0.02), Lockstep::Seconds(0.02)});
  simulation->tick();
  EXPECT_EQ(1U, textsOf(*simulation, Event::Kind::kParticipantLate).size());
  simulation->apply(SetCommandSource{"fb_2", CommandSource::kNone});
  simulation->tick();
  EXPECT_TRUE(textsOf(*simulation, Event::Kind::kParticipantLate).empty());
  simulation->apply(SetCommandSource{"fb_2", CommandSource::kRemote});
  simulation->tick();
  EXPECT_EQ(1U, textsOf(*simulation, Event::Kind::kParticipantLate).size()) << "it is offered anew";
}

TEST(LockstepTest, RefusesAnswersThatNobodyWaitsFor) {
  auto simulation = oneRobot();
  FakeParticipant participant(*simulation, "a", {"fb"});
  const Registration first = participant.join();
  participant.more_answers = 1;
  simulation->tick();
  EXPECT_EQ((std::vector<std::string>{"", "answered twice for tick 0"}), participant.refusals);
  participant.tick_error = 3;
  simulation->tick();
  EXPECT_EQ("answered for tick 4 of run 0, asked for tick 1 of run 0", participant.refusals.back());
  EXPECT_EQ(2U, simulation->lockstep().reports().front().refused);
  participant.more_answers = 0;
  participant.join();
  EXPECT_EQ("session 1 is over, or never was", simulation->lockstep().answer({{first.session, 0, 2}, {}}));
  auto in_process = oneRobot("controller");
  EXPECT_EQ(hashesOf(*in_process, 2).back(), simulation->stateHash()) << "what was refused has moved somebody";
}

TEST(LockstepTest, ABadFrameStopsItsRobot) {
  auto simulation = oneRobot();
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.join();
  participant.cuts_short = true;
  simulation->tick();
  ASSERT_EQ(1U, simulation->failures().size());
  EXPECT_EQ("participant 'a' sent a bad command frame: fb: found 3 bytes, expected at least 4",
            simulation->failures()[0].reason);
}

TEST(LockstepTest, AControllerThatThrowsElsewhereStopsItsRobot) {
  auto simulation = oneRobot("remote", "<throw_at>3</throw_at>");
  auto in_process = oneRobot("controller", "<throw_at>3</throw_at>");
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.join();
  EXPECT_EQ(hashesOf(*in_process, 10), hashesOf(*simulation, 10));
  ASSERT_EQ(1U, simulation->failures().size());
  EXPECT_EQ("told to", simulation->failures()[0].reason);
  EXPECT_EQ(3U, simulation->failures()[0].tick);
  EXPECT_EQ(4, participant.frames) << "nothing is asked for a robot that has failed";
}

std::string refusalOf(Simulation& simulation, const std::string& name, const std::vector<std::string>& robots) {
  try {
    simulation.lockstep().join({name, robots, std::nullopt, std::nullopt}, [](const SensorFrame&) {});
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(LockstepTest, RefusesWhoCannotCommand) {
  auto simulation = remoteRetrieval({kEyebot});
  EXPECT_EQ("robot 'fb_1' is not commanded from another process; those are: eb", refusalOf(*simulation, "a", {"fb_1"}));
  EXPECT_EQ("found robot 'eb' twice, allowed: once", refusalOf(*simulation, "a", {"eb", "eb"}));
  EXPECT_EQ("", refusalOf(*simulation, "a", {"eb"}));
  EXPECT_EQ("robot 'eb' is commanded by participant 'a'", refusalOf(*simulation, "b", {"eb"}));
  EXPECT_EQ("", refusalOf(*simulation, "a", {"eb"})) << "its former self is replaced";
}

TEST(LockstepTest, AnInterruptEndsTheWaiting) {
  auto simulation = oneRobot();
  std::thread other([&] {
    std::this_thread::sleep_for(20ms);
    simulation->interrupt();
  });
  EXPECT_THROW(simulation->tick(), std::runtime_error);
  other.join();
}

TEST(LockstepTest, NobodyCommandsARobotWithoutASource) {
  auto simulation = oneRobot("none");
  hashesOf(*simulation, 10);
  EXPECT_EQ(1.0, xOf(*simulation));
}

TEST(LockstepTest, TheSourceChangesWhileItRuns) {
  auto simulation = oneRobot("none");
  simulation->apply(SetCommandSource{"fb", CommandSource::kController});
  hashesOf(*simulation, 5);
  const double driven = xOf(*simulation);
  EXPECT_GT(driven, 1.05);
  simulation->apply(SetCommandSource{"fb", CommandSource::kRemote});
  simulation->apply(SetCommandSource{"fb", CommandSource::kRemote});
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.join();
  simulation->tick();
  EXPECT_EQ(std::vector<std::string>{"fb: commands from remote, no more from controller"},
            textsOf(*simulation, Event::Kind::kIntervention));
  EXPECT_GT(xOf(*simulation), driven);
  simulation->apply(SetCommandSource{"fb", CommandSource::kNone});
  const double stopped = xOf(*simulation);
  hashesOf(*simulation, 5);
  EXPECT_EQ(stopped, xOf(*simulation));
  EXPECT_EQ(1, participant.frames);
  EXPECT_THROW(simulation->apply(SetCommandSource{"wall", CommandSource::kNone}), ConfigError);
  simulation->reset();
  hashesOf(*simulation, 5);
  EXPECT_EQ(1.0, xOf(*simulation)) << "a reset puts the file's source back";
}

TEST(LockstepTest, NobodyAsksForTheCommandsOfARobotThatHasFallen) {
  World world;
  std::string robot = footbot("fb", 1, 1, 0);
  robot.replace(robot.find("<controller>"), 12, "<controller source=\"remote\">");
  world.entities = robot + "<hole id=\"pit\"><position>1.15,1,0</position><radius>0.1</radius></hole>";
  world.members = member("fb");
  world.drive = "<left>5</left><right>5</right>";
  auto simulation = world.make();
  simulation->start();
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.join();
  hashesOf(*simulation, 4);  // by 14.5 mm per tick, to the rim at 1.05
  EXPECT_EQ(std::vector<std::string>{"fb: hole 'pit'"}, textsOf(*simulation, Event::Kind::kFellIntoHole));
  hashesOf(*simulation, 5);
  EXPECT_EQ(4, participant.frames);
  EXPECT_EQ(std::vector<std::string>(4, ""), participant.refusals);
  EXPECT_EQ(9U, simulation->space().tick);
  simulation->reset();
  EXPECT_EQ(1U, simulation->robotCount());
}

TEST(LockstepTest, ARobotMayGoAndComeBack) {
  auto simulation = remoteRetrieval({kEyebot});
  FakeParticipant participant(*simulation, "a", {"eb"});
  participant.join();
  hashesOf(*simulation, 5);
  const int frames = participant.frames;
  simulation->apply(DeleteEntity{"eb"});
  hashesOf(*simulation, 5);
  EXPECT_EQ(frames, participant.frames);
}

}  // namespace
}  // namespace swarmanoid::test
