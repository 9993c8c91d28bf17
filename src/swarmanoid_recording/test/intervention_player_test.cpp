// Playing files of interventions into runs, and recording them.
#include "swarmanoid_space/simulation/intervention_player.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "swarmanoid_experiment_files/interventions/intervention_file.hpp"
#include "swarmanoid_experiment_files/interventions/read_player.hpp"
#include "swarmanoid_experiment_files/testing/intervention_texts.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_recording/output/run_files.hpp"

namespace swarmanoid {
namespace {

using test::fileOf;
using test::namedParts;

TEST(InterventionPlayerTest, WhatIsStrangeAboutPlayingItIsSaid) {
  Experiment experiment = namedParts();  // small_world, seed 1, 50 ticks
  RuleDescription rule;
  rule.id = "mine";
  experiment.rules.push_back(rule);
  const std::string elements =
      "<delete tick='1' by=\"rule 'mine' (x)\" entity='x'/>\n<delete tick='2' by=\"rule 'gone' (x)\" entity='x'/>\n"
      "<delete tick='50' entity='x'/><delete tick='51' entity='x'/>";
  const InterventionFile file = parseInterventions(
      "<interventions experiment='other' seed='2'>\n" + elements + "</interventions>", "f.xml", experiment);
  using Lines = std::vector<std::string>;
  const Lines always{"f.xml: recorded with the experiment 'other', played into 'small_world'",
                     "f.xml: recorded with the seed 2, played into a run with the seed 1",
                     "f.xml:4: 2 interventions from tick 50 on will not be played, the run ends after 50 ticks"};
  Lines left_out = always;
  left_out.push_back(
      "f.xml: 1 intervention of rule 'gone' (x) will not be played, and the run has no such rule to ask "
      "for them");
  EXPECT_EQ(playingWarnings(file, AskedByRules::kLeftOut, experiment), left_out);
  Lines played = always;
  played.push_back(
      "f.xml: 1 intervention of rule 'mine' (x) will be played, and the run has that rule, which may ask "
      "for them too");
  EXPECT_EQ(playingWarnings(file, AskedByRules::kPlayed, experiment), played);
  EXPECT_EQ(InterventionPlayer(file.interventions, AskedByRules::kLeftOut).left(), 2U);
  EXPECT_EQ(InterventionPlayer(file.interventions, AskedByRules::kPlayed).left(), 4U);
}

TEST(InterventionPlayerTest, ThePlayerGivesEachInItsTickAndThoseAfterTheRulesAfterThem) {
  const InterventionFile file = parseInterventions(
      fileOf(
          "<delete tick='0' entity='a'/><delete tick='2' entity='b'/><delete tick='2' after_rules='true' entity='c'/>"),
      "f.xml", namedParts());
  InterventionPlayer player(file.interventions, AskedByRules::kLeftOut);
  const auto due = [&](std::uint64_t tick, bool after_rules) {
    std::string names;
    while (const RecordedIntervention* next = player.takeDue(tick, after_rules)) {
      names += std::get<DeleteEntity>(next->taken.what).entity;
    }
    return names;
  };
  for (int run = 0; run < 2; ++run) {
    EXPECT_EQ(due(0, false), "a");
    EXPECT_EQ(due(0, true), "");
    EXPECT_EQ(due(1, false) + due(1, true), "");
    EXPECT_EQ(due(2, false), "b");
    EXPECT_EQ(player.left(), 1U);
    EXPECT_EQ(due(2, true), "c");
    EXPECT_EQ(player.left(), 0U);
    player.restart();
  }
}
class InterventionRecorderTest : public testing::Test {
 protected:
  InterventionRecorderTest() {
    loadPluginLibrary("swarmanoid_visualisations", {}, {});
    RunFiles files;
    files.prefix = "--";
    files.folder = owner.path();
    RunContext context;
    context.out = openOutFolder(files, {});
    Configuration parameters("intervention_recorder", "", {});
    parameters.set("file", "done.xml");
    addObserver(*simulation, context, "--save-interventions", "recorder", parameters);
    context.out->keep();
    simulation->start();
  }

  InterventionFile read() const { return readInterventions(owner.path() / "done.xml", simulation->experiment()); }

  const TemporaryFolder owner{"intervention_player_test"};
  const std::unique_ptr<Simulation> simulation = test::smallWorld(5);
};

TEST_F(InterventionRecorderTest, WritesAsTheRunGoesAndTheEndWhenItIsOver) {
  simulation->tick();
  simulation->apply(DeleteEntity{"prey"});
  simulation->tick();
  try {
    read();
    ADD_FAILURE() << "the run is not over";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("found no </interventions> at the end"), std::string::npos);
  }
  std::ofstream(owner.path() / "done.xml", std::ios::app) << "</interventions>\n";  // as described in the documentation
  EXPECT_EQ(read().interventions.size(), 1U);
  simulation->reset(9);
  simulation->tick();
  simulation->tick();
  simulation->apply(DeleteEntity{"lamp"});
  simulation->tick();
  simulation->finish();
  const InterventionFile file = read();
  EXPECT_EQ(file.seed, "9");
  EXPECT_EQ(file.experiment, "small_world");
  ASSERT_EQ(file.interventions.size(), 1U);
  EXPECT_EQ(file.interventions[0].taken.tick, 2U);
  EXPECT_EQ(std::get<DeleteEntity>(file.interventions[0].taken.what).entity, "lamp");
}

TEST_F(InterventionRecorderTest, ARunInWhichNothingWasDoneHasAWholeFile) {
  simulation->finish();
  EXPECT_TRUE(read().interventions.empty());
}

}  // namespace
}  // namespace swarmanoid
