// External interventions, recorded and played into another run: the same hashes in each tick.
#include <gtest/gtest.h>

#include "lockstep_world.hpp"
#include "random_interventions.hpp"
#include "swarmanoid_experiment_files/interventions/intervention_file.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_recording/output/out_folder.hpp"
#include "swarmanoid_recording/output/run_files.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::test {
namespace {

class RuledReplayTest : public testing::Test {
 protected:
  void record(Simulation& simulation) const {
    RunFiles files;
    files.folder = owner.path();
    RunContext context;
    context.out = openOutFolder(files, {});
    Configuration parameters("intervention_recorder", "", {});
    parameters.set("file", "done.xml");
    addObserver(simulation, context, "--save-interventions", "recorder", parameters);
    context.out->keep();
  }

  std::unique_ptr<Simulation> replayed(const World& world, AskedByRules asked_by_rules = AskedByRules::kLeftOut) const {
    auto simulation = world.make();
    simulation->play(
        {readInterventions(owner.path() / "done.xml", simulation->experiment()).interventions, asked_by_rules});
    simulation->start();
    return simulation;
  }

  const TemporaryFolder owner{"intervention_replay_test"};
};

class ReplayTest : public RuledReplayTest, public testing::WithParamInterface<const char*> {};

TEST_P(ReplayTest, TwoHundredRandomInterventionsHaveTheSameHashesAgainAndAfterAReset) {
  const World world = crowdedWorld(GetParam());
  auto simulation = world.make();
  record(*simulation);
  simulation->start();
  RandomInterventions interventions(GetParam(), 3);
  Tried tried;
  const auto expected = disturb(*simulation, interventions, 200, tried);
  simulation->finish();
  EXPECT_GT(tried.refused, 20);
  for (std::size_t kind = 0; kind < tried.carried_out.size(); ++kind) {
    const bool has_no_live_parameters = GetParam() == std::string("ground") && kind == 4;
    EXPECT_GT(tried.carried_out[kind], has_no_live_parameters ? -1 : 0) << "kind " << kind;
  }

  const auto again = replayed(world);
  const std::uint64_t ticks = expected.size();
  EXPECT_EQ(hashesOf(*again, ticks), expected);
  EXPECT_EQ(again->interventionsLeft(), 0U);
  EXPECT_EQ(deepHash(again->space()), deepHash(simulation->space()));
  again->reset();
  EXPECT_GT(again->interventionsLeft(), 0U);
  EXPECT_EQ(hashesOf(*again, ticks), expected);
}

INSTANTIATE_TEST_SUITE_P(Engines, ReplayTest, testing::ValuesIn(kEngineIds));

/// Moves "fb" to (3, 3) before tick 2, and to (5, 5) after tick 4.
class PuttingRule final : public Rule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "putting";
    return description;
  }
  void configure(const Configuration&) override {}
  void beforeTick(const Space& space, InterventionQueue& queue) override {
    if (space.tick == 2) {
      put(3.0, queue);
    }
  }
  void afterTick(const Space& space, InterventionQueue& queue) override {
    if (space.tick == 5) {
      put(5.0, queue);
    }
  }

 private:
  static void put(double place, InterventionQueue& queue) {
    queue.ask(MoveEntity{"fb", {{place, place, 0.0}, Eigen::Quaterniond::Identity()}});
  }
};

/// @param source of the robot's commands: in this process or another one
World ruledWorld(const std::string& source) {
  World world;
  std::string robot = footbot("fb", 1, 1, 0);
  robot.replace(robot.find("<controller>"), 12, "<controller source=\"" + source + "\">");
  world.entities = robot;
  world.members = member("fb");
  world.drive = "<left>5</left><right>5</right>";
  world.rules = "<putting id='mine'/>";
  return world;
}

void putTo(Simulation& simulation, double place) {
  simulation.apply(MoveEntity{"fb", {{place, place, 0.0}, Eigen::Quaterniond::Identity()}});
}

TEST_F(RuledReplayTest, WhatRulesAskForIsLeftOutAndAskedForAgain) {
  auto simulation = ruledWorld("controller").make();
  record(*simulation);
  simulation->start();
  auto expected = hashesOf(*simulation, 2);
  putTo(*simulation, 7.0);  // in the same tick, and before the rule's
  for (const std::uint64_t hash : hashesOf(*simulation, 6)) {
    expected.push_back(hash);
  }
  EXPECT_NEAR(poseOf(*simulation, "fb").position.y(), 5.0, 1e-6);
  simulation->finish();
  EXPECT_EQ(hashesOf(*replayed(ruledWorld("controller")), 8), expected);
  World without = ruledWorld("controller");
  without.rules.clear();
  EXPECT_EQ(hashesOf(*replayed(without, AskedByRules::kPlayed), 8), expected);
  EXPECT_NE(hashesOf(*replayed(without, AskedByRules::kLeftOut), 8), expected);
  const auto names = readInterventions(owner.path() / "done.xml", simulation->experiment()).interventions;
  ASSERT_EQ(names.size(), 3U);
  EXPECT_EQ(names[0].taken.asked_by, "");
  EXPECT_EQ(names[1].taken.asked_by, "rule 'mine' (putting)");
  EXPECT_EQ(names[1].taken.tick, 2U);
  EXPECT_EQ(names[2].taken.tick, 5U);
}

TEST_F(RuledReplayTest, WhatWasDoneInATickThatWasGivenUpComesAfterTheRules) {
  auto simulation = ruledWorld("remote").make();
  record(*simulation);
  simulation->start();
  FakeParticipant participant(*simulation, "a", {"fb"});
  participant.join();
  auto expected = hashesOf(*simulation, 2);
  participant.is_mute = true;
  EXPECT_FALSE(simulation->tick([] { return true; }));
  putTo(*simulation, 7.0);
  participant.is_mute = false;
  participant.answerLate();
  for (const std::uint64_t hash : hashesOf(*simulation, 3)) {
    expected.push_back(hash);
  }
  EXPECT_NEAR(poseOf(*simulation, "fb").position.y(), 7.0, 1e-6);
  simulation->finish();
  const auto recorded = readInterventions(owner.path() / "done.xml", simulation->experiment()).interventions;
  ASSERT_GE(recorded.size(), 2U);
  EXPECT_FALSE(recorded[0].taken.after_rules);
  EXPECT_TRUE(recorded[1].taken.after_rules);
  EXPECT_EQ(recorded[1].taken.asked_by, "");
  EXPECT_EQ(hashesOf(*replayed(ruledWorld("controller")), 5), expected);
}

TEST_F(RuledReplayTest, ARefusedOneEndsTheRunWithFileLineTickAndReason) {
  auto simulation = ruledWorld("controller").make();
  const std::string text =
      "<interventions>\n<command_source tick='1' robot='fb' source='none'/>\n<delete tick='3' entity='gone'/>\n"
      "</interventions>";
  simulation->play({parseInterventions(text, "f.xml", simulation->experiment()).interventions, AskedByRules::kLeftOut});
  simulation->start();
  tick(*simulation, 3);
  try {
    simulation->tick();
    ADD_FAILURE() << "it goes on";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "f.xml:3: <delete> is refused in tick 3: there is no entity 'gone'");
  }
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_RULE(swarmanoid::test::PuttingRule)
