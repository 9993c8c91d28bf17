// Runs with 200 random interventions, recorded in a folder and repeated from the folder alone: the same hashes in each
// tick. And forks of a run.
#include <gtest/gtest.h>

#include "random_interventions.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/process/temporary_folder.hpp"
#include "swarmanoid_recording/output/run_files.hpp"
#include "swarmanoid_recording/records/record_folder.hpp"
#include "swarmanoid_recording/records/recorded_run.hpp"
#include "swarmanoid_space/rule.hpp"

namespace swarmanoid::test {
namespace {

class RecordTest : public testing::Test {
 protected:
  /// Writes the record of a simulation that has not started, as the program does.
  std::unique_ptr<RecordFolder> record(Simulation& simulation) const {
    RunFiles files;
    files.folder = owner.path();
    RunContext context;
    context.out = openOutFolder(files, {});
    auto record = std::make_unique<RecordFolder>(*context.out, "done", OutFolder::Writer{"--record", {}, false},
                                                 recordOf(simulation.experiment(), "1.2.3"));
    for (const auto& [label, file] : {std::pair("hash_recorder", record_files::kHashes),
                                      std::pair("intervention_recorder", record_files::kInterventions)}) {
      Configuration parameters(label, "", {});
      parameters.set("file", "done/" + std::string(file));
      addObserver(simulation, context, "--record", label, parameters);
    }
    context.out->keep();
    record->begin();
    return record;
  }

  RecordedRun recorded() const { return readRecordedRun(owner.path() / "done"); }

  static std::unique_ptr<Simulation> again(const RecordedRun& run) {
    auto simulation = std::make_unique<Simulation>(experimentOf(run));
    const Experiment& experiment = simulation->experiment();
    simulation->play(
        {withoutThoseOfRules(interventionsOf(run, experiment), experiment).interventions, AskedByRules::kPlayed});
    simulation->start();
    return simulation;
  }

  const TemporaryFolder owner{"record_test"};
};

class RecordInEngineTest : public RecordTest, public testing::WithParamInterface<const char*> {};

TEST_P(RecordInEngineTest, TwoHundredRandomInterventionsAreInTheRecord) {
  auto simulation = crowdedWorld(GetParam()).make();
  const auto folder = record(*simulation);
  simulation->start();
  RandomInterventions interventions(GetParam(), 7);
  Tried tried;
  const auto expected = disturb(*simulation, interventions, 200, tried);
  simulation->finish();
  folder->finish("{}\n");
  EXPECT_GT(tried.refused, 20);
  for (std::size_t kind = 0; kind < tried.carried_out.size(); ++kind) {
    const bool has_no_live_parameters = GetParam() == std::string("ground") && kind == 4;
    EXPECT_GT(tried.carried_out[kind], has_no_live_parameters ? -1 : 0) << "kind " << kind;
  }

  const RecordedRun run = recorded();
  ASSERT_EQ(run.ticks(), expected.size());
  EXPECT_EQ(run.missing, std::vector<std::string>{});
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(run.hashes[i + 1].hash, expected[i]);
  }
  const auto second = again(run);
  EXPECT_EQ(second->stateHash(), run.hashes[0].hash);
  EXPECT_EQ(hashesOf(*second, expected.size()), expected);
  EXPECT_EQ(deepHash(second->space()), deepHash(simulation->space()));
}

INSTANTIATE_TEST_SUITE_P(Engines, RecordInEngineTest, testing::ValuesIn(kEngineIds));

World wanderingWorld() {
  World world;
  world.ticks = 50;
  world.drive = "<left>0</left><right>0</right><random>true</random>";
  world.entities = footbot("fb_1", 3, 3, 12) + footbot("fb_2", 7, 6, -50);
  world.members = member("fb_1") + member("fb_2");
  return world;
}

std::unique_ptr<Simulation> wandering(std::uint64_t seed) {
  World world = wanderingWorld();
  world.framework = "<random_seed>" + std::to_string(seed) + "</random_seed>";
  auto simulation = world.make();
  simulation->start();
  return simulation;
}

/// One robot drives over an edge, another one is moved onto a hole, a third one is spawned with the name of the first.
TEST_F(RecordTest, WhoFellFallsAgain) {
  World world = wanderingWorld();
  world.drive = "<left>5</left><right>5</right>";
  world.entities += "<hole id=\"pit\"><position>3.2,3,0</position><size>0.1,4</size></hole>";
  auto simulation = world.make();
  const auto folder = record(*simulation);
  simulation->start();
  auto expected = hashesOf(*simulation, 15);
  ASSERT_EQ(simulation->robotCount(), 1U);
  simulation->apply(MoveEntity{"fb_2", {{3.2, 2.5, 0}, Eigen::Quaterniond::Identity()}});
  EntityDescription entity;
  entity.type = "footbot";
  entity.id = "fb_1";
  entity.position = {5, 5, 0};
  entity.controller = "drive";
  simulation->apply(SpawnEntity{entity, {"ground"}});
  const auto more = hashesOf(*simulation, 15);
  expected.insert(expected.end(), more.begin(), more.end());
  EXPECT_EQ(simulation->robotCount(), 1U);
  simulation->finish();
  folder->finish("{}\n");
  const auto second = again(recorded());
  EXPECT_EQ(hashesOf(*second, expected.size()), expected);
  EXPECT_EQ(deepHash(second->space()), deepHash(simulation->space()));
}

/// That world draws no random numbers before its first tick.
TEST_F(RecordTest, AnotherSeedBeforeTheFirstTickIsARunOfThatSeed) {
  const auto with_nine = wandering(9);
  const auto expected = hashesOf(*with_nine, 20);
  const auto reseeded = wandering(1);
  reseeded->reseed(9);
  EXPECT_EQ(hashesOf(*reseeded, 20), expected);
  EXPECT_EQ(reseeded->space().seed, 9U);
}

TEST_F(RecordTest, AnotherSeedInTheMiddleChangesWhatComesAndNothingElse) {
  const auto plain = wandering(4);
  const auto expected = hashesOf(*plain, 13);
  const auto parted = wandering(4);
  EXPECT_EQ(hashesOf(*parted, 7), std::vector<std::uint64_t>(expected.begin(), expected.begin() + 7));
  parted->reseed(5);
  EXPECT_EQ(parted->stateHash(), expected[6]);
  const auto after = hashesOf(*parted, 6);
  EXPECT_NE(after[0], expected[7]);
  const auto same = wandering(4);
  hashesOf(*same, 7);
  same->reseed(4);
  EXPECT_EQ(hashesOf(*same, 6), std::vector<std::uint64_t>(expected.begin() + 7, expected.end()));
}

/// Turns the first robot by a random angle in each tick.
class SpinningRule final : public Rule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "spinning";
    return description;
  }
  void configure(const Configuration&) override {}
  void beforeTick(const Space&, InterventionQueue& queue) override {
    const Eigen::AngleAxisd turn(random().uniform(-M_PI, M_PI), Eigen::Vector3d::UnitZ());
    queue.ask(MoveEntity{"fb_1", {{3.0, 3.0, 0.0}, Eigen::Quaterniond(turn)}});
  }
};

/// A part that may draw random numbers, and its place in the experiment file.
struct Drawing {
  const char* name;
  std::string_view instead_of;
  std::string_view text;
  bool is_fault = false;
};

constexpr std::array<Drawing, 5> kDrawings{{
    {"DeviceOfItsOwn", "<footbot_proximity/>", "<footbot_camera><noise_distance>0.1</noise_distance></footbot_camera>"},
    {"ErrorOfASensor", "<footbot_proximity/>",
     "<footbot_proximity><error kind='gaussian' deviation='0.1'/></footbot_proximity>"},
    {"ErrorOfAnActuator", "<footbot_wheels/>",
     "<footbot_wheels><error kind='gaussian' deviation='0.5'/></footbot_wheels>"},
    {"Rule", "<rules>", "<rules><spinning id='mine'/>"},
    {"Fault", "", "", true},
}};

/// The controllers draw no random numbers, and a prey is in sight. @return after 7 ticks
std::unique_ptr<Simulation> sevenTicksOf(const Drawing& drawing, std::uint64_t seed) {
  loadBuiltInPlugins();
  World world = wanderingWorld();
  world.drive = "<left>1</left><right>1.5</right>";
  world.entities += prey("prey", 3.8, 3.1);
  world.framework = "<random_seed>" + std::to_string(seed) + "</random_seed>";
  std::string text = world.xml();
  text.replace(text.find(drawing.instead_of), drawing.instead_of.size(), drawing.text);
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "test.xml"));
  simulation->start();
  if (drawing.is_fault) {
    ErrorModelDescription error;
    error.kind = "gaussian";
    error.parameters.set("deviation", "0.5");
    simulation->apply(SetFault{"fb_1", "footbot_wheels", {error}});
  }
  hashesOf(*simulation, 7);
  return simulation;
}

std::uint64_t deepAfterATick(Simulation& simulation) {
  simulation.tick();
  return deepHash(simulation.space());
}

class ReseedTest : public testing::TestWithParam<Drawing> {};

TEST_P(ReseedTest, AnotherSeedChangesWhatIsDrawnFromThenOn) {
  const auto plain = sevenTicksOf(GetParam(), 4);
  const auto parted = sevenTicksOf(GetParam(), 4);
  const auto same = sevenTicksOf(GetParam(), 4);
  const std::uint64_t before = deepHash(plain->space());
  parted->reseed(5);
  same->reseed(4);
  EXPECT_EQ(deepHash(parted->space()), before) << "what was drawn stays";
  const std::uint64_t expected = deepAfterATick(*plain);
  EXPECT_NE(deepAfterATick(*parted), expected);
  EXPECT_EQ(deepAfterATick(*same), expected);
}

INSTANTIATE_TEST_SUITE_P(Drawings, ReseedTest, testing::ValuesIn(kDrawings),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(ReseedNothingTest, WhereNothingIsDrawnItChangesNothing) {
  const Drawing none{"Nothing", "", ""};
  const auto plain = sevenTicksOf(none, 4);
  const auto parted = sevenTicksOf(none, 4);
  parted->reseed(5);
  EXPECT_EQ(deepAfterATick(*parted), deepAfterATick(*plain));
}

/// Moves the first robot in tick 3.
class ShovingRule final : public Rule {
 public:
  static PluginDescription describe() {
    PluginDescription description;
    description.label = "shoving";
    return description;
  }
  void configure(const Configuration&) override {}
  void beforeTick(const Space& space, InterventionQueue& queue) override {
    if (space.tick == 3) {
      queue.ask(MoveEntity{"fb_1", {{1.5, 8.25, 0.0}, Eigen::Quaterniond::Identity()}});
    }
  }
};

TEST_F(RecordTest, WhatRulesAskedForIsPlayedOnlyIfNoRuleAsksForItAgain) {
  World ruled = wanderingWorld();
  ruled.rules = "<shoving id='mine'/>";
  auto simulation = ruled.make();
  const auto folder = record(*simulation);
  simulation->start();
  const auto expected = hashesOf(*simulation, 9);
  simulation->finish();
  folder->finish("{}\n");
  const RecordedRun run = recorded();
  EXPECT_EQ(hashesOf(*again(run), 9), expected);
  InterventionFile all = interventionsOf(run, simulation->experiment());
  ASSERT_EQ(all.interventions.size(), 1U);
  EXPECT_EQ(withoutThoseOfRules(all, simulation->experiment()).interventions.size(), 0U);
  EXPECT_EQ(withoutThoseOfRules(all, wanderingWorld().make()->experiment()).interventions.size(), 1U);
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_RULE(swarmanoid::test::ShovingRule)
REGISTER_RULE(swarmanoid::test::SpinningRule)
