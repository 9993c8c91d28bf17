// Foraging: preys in the nest are counted once and moved elsewhere. No engine detects collisions here, so every place
// is free; with engines: swarmanoid_experiments/test/foraging_test.cpp.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

/// The nest is a disc of 0.4 m around (1, 1); preys return to x from 2 to 4 and y from 1.5 to 3.
constexpr const char* kBox = "<minimum>2, 1.5, 0</minimum><maximum>4, 3, 0.5</maximum>";

/// @param robots elements of the arena
Experiment foraging(const std::string& parameters, const std::string& robots = "") {
  loadPluginLibrary("swarmanoid_devices", {}, {});
  return parseExperiment(R"(<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>100000</maxclock></framework>
  <arena size="5,5,3" optimization="2D">
    <floor_patch id="food"><position>3, 3, 0</position><size>1, 1</size></floor_patch>
    <floor_patch id="nest"><position>1, 1, 0</position><radius>0.4</radius></floor_patch>
    <cylindric_prey id="prey_1"><position>3, 4, 0</position><orientation>0, 0, 0</orientation>
      <radius>0.06</radius><height>0.1</height></cylindric_prey>
    <cylindric_prey id="prey_2"><position>4, 4, 0</position><orientation>0, 0, 0</orientation>
      <radius>0.06</radius><height>0.1</height></cylindric_prey>
    <cylindric_prey id="stone_prey"><position>1, 1, 0</position><orientation>0, 0, 0</orientation>
      <radius>0.06</radius><height>0.1</height></cylindric_prey>)" +
                             robots + R"(
  </arena>
  <rules><foraging id="f">)" +
                             parameters + "</foraging></rules></ahss-config>",
                         "foraging.xml");
}

class ForagingTest : public testing::Test {
 protected:
  explicit ForagingTest(const std::string& parameters = kBox) : simulation(foraging(parameters)) { simulation.start(); }

  double metric(const std::string& name) const { return std::get<double>(simulation.metrics().at("f." + name)); }
  const Pose& poseOf(const std::string& name) const {
    const Entities& entities = simulation.space().entities;
    return entities.pose[entities.find(name)];
  }
  EntityNumber numberOf(const std::string& name) const {
    const Entities& entities = simulation.space().entities;
    return entities.number[entities.find(name)];
  }
  /// Moves a prey as a robot would, tilted.
  void bring(const std::string& prey, double x, double y) {
    simulation.apply(MoveEntity{prey, {{x, y, 0.02}, Eigen::Quaterniond(0.8, 0.6, 0.0, 0.0)}});
  }

  Simulation simulation;
};

TEST_F(ForagingTest, APreyInTheNestIsCountedAndThenLiesElsewhere) {
  const EntityNumber number = numberOf("prey_1");
  bring("prey_1", 1.39, 1.0);
  simulation.tick();
  EXPECT_EQ(metric("preys"), 1.0);
  EXPECT_DOUBLE_EQ(metric("preys_per_minute"), 600.0) << "1 in 0.1 s";
  EXPECT_EQ(metric("preys_per_kilojoule"), 0.0) << "nobody runs on a battery";
  EXPECT_EQ(poseOf("prey_1").position.x(), 1.39) << "not in this tick";
  simulation.tick();
  EXPECT_EQ(metric("preys"), 1.0) << "once";
  EXPECT_DOUBLE_EQ(metric("preys_per_minute"), 300.0);
  EXPECT_EQ(numberOf("prey_1"), number) << "the same entity";
  const Pose& pose = poseOf("prey_1");
  EXPECT_GE(pose.position.x(), 2.0);
  EXPECT_LE(pose.position.x(), 4.0);
  EXPECT_GE(pose.position.y(), 1.5);
  EXPECT_LE(pose.position.y(), 3.0);
  EXPECT_GE(pose.position.z(), 0.0);
  EXPECT_LE(pose.position.z(), 0.5);
  EXPECT_EQ(pose.orientation.coeffs(), Eigen::Quaterniond::Identity().coeffs()) << "upright";
  const std::vector<TakenIntervention>& taken = simulation.space().interventions;
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].asked_by, "rule 'f' (foraging)");
  const Eigen::Vector3d there = pose.position;
  simulation.tick();
  EXPECT_EQ(poseOf("prey_1").position, there) << "there it stays";
}

TEST_F(ForagingTest, OnlyPreysInTheNestCount) {
  bring("prey_1", 1.41, 1.0);
  bring("prey_2", 3.0, 3.0);
  simulation.tick();
  simulation.tick();
  EXPECT_EQ(metric("preys"), 0.0) << "beside it, in another patch, and under another name";
  EXPECT_EQ(metric("preys_per_minute"), 0.0);
  EXPECT_EQ(poseOf("stone_prey").position.x(), 1.0);
  EXPECT_EQ(poseOf("prey_1").position.x(), 1.41);
}

TEST_F(ForagingTest, EachIsCountedAsOftenAsItIsBrought) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  constexpr int kTimes = 200;
  for (int i = 0; i < kTimes; ++i) {
    bring("prey_1", 1.0, 1.0);
    bring("prey_2", 0.8, 1.1);
    simulation.tick();
    simulation.tick();
    sum += poseOf("prey_1").position + poseOf("prey_2").position;
  }
  EXPECT_EQ(metric("preys"), 2.0 * kTimes);
  // the standard error of the mean of a uniform variable is its width / sqrt(12 n)
  const Eigen::Vector3d mean = sum / (2.0 * kTimes);
  EXPECT_NEAR(mean.x(), 3.0, 4.0 * 2.0 / std::sqrt(12.0 * 400.0));
  EXPECT_NEAR(mean.y(), 2.25, 4.0 * 1.5 / std::sqrt(12.0 * 400.0));
  EXPECT_NEAR(mean.z(), 0.25, 4.0 * 0.5 / std::sqrt(12.0 * 400.0));
}

TEST_F(ForagingTest, OneThatIsDeletedOrTakenAwayIsForgotten) {
  bring("prey_1", 1.0, 1.0);
  bring("prey_2", 1.0, 1.2);
  simulation.tick();
  EXPECT_EQ(metric("preys"), 2.0);
  simulation.apply(DeleteEntity{"prey_1"});  // before the request of the rule takes effect
  simulation.tick();
  EXPECT_EQ(metric("preys"), 2.0);
  ASSERT_FALSE(simulation.space().events.empty());
  EXPECT_EQ(simulation.space().events[1].kind, Event::Kind::kInterventionRefused);
  simulation.tick();
  EXPECT_TRUE(simulation.space().events.empty()) << "it is not asked for any more";
}

TEST_F(ForagingTest, ATickInWhichNothingIsBroughtTouchesNoHeap) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  bring("prey_1", 1.0, 1.0);
  for (int i = 0; i < 10; ++i) {
    simulation.tick();
  }
  const long before = heap_allocations;
  for (int i = 0; i < 100; ++i) {
    simulation.tick();
  }
  EXPECT_EQ(heap_allocations - before, 0);
  EXPECT_GT(before, 100) << "the counting works";
}

TEST_F(ForagingTest, AResetStartsAnew) {
  bring("prey_1", 1.0, 1.0);
  simulation.tick();
  simulation.reset();
  EXPECT_EQ(metric("preys"), 0.0);
  EXPECT_EQ(metric("preys_per_minute"), 0.0);
  simulation.tick();
  simulation.tick();
  EXPECT_EQ(poseOf("prey_1").position.x(), 3.0) << "it waits no more";
  bring("prey_1", 1.0, 1.0);
  simulation.tick();
  EXPECT_EQ(metric("preys"), 1.0);
}

TEST_F(ForagingTest, NoPreyComesBackIntoTheNest) {
  // nine tenths of the box are in the nest
  Simulation around(foraging("<minimum>0.8, 0.8, 0</minimum><maximum>1.4, 1.4, 0</maximum>"));
  around.start();
  const Space& space = around.space();
  double expected = 0.0;
  for (int i = 0; i < 100; ++i) {
    const Row row = space.entities.find("prey_1");
    around.apply(MoveEntity{"prey_1", {{1.0, 1.0, 0.0}, Eigen::Quaterniond::Identity()}});
    expected += 1.0;
    for (int k = 0; k < 200 && (k == 0 || space.floor.patches[1].contains(space.entities.pose[row].position)); ++k) {
      around.tick();
    }
    ASSERT_FALSE(space.floor.patches[1].contains(space.entities.pose[row].position));
    around.tick();
    EXPECT_EQ(std::get<double>(around.metrics().at("f.preys")), expected);
  }
}

// Robots without a controller all draw the same power, that of their electronics: two robots use in ten ticks what one
// uses in twenty.
TEST(ForagingEfficiencyTest, WhatDeletedRobotsHaveUsedStillCounts) {
  Simulation simulation(foraging(kBox, R"(
    <footbot id="fb_1"><position>1, 4, 0</position><orientation>0, 0, 0</orientation><battery>true</battery></footbot>
    <footbot id="fb_2"><position>2, 4, 0</position><orientation>0, 0, 0</orientation><battery>true</battery></footbot>
  )"));
  simulation.start();
  const Space& space = simulation.space();
  const auto usedBy = [&space](const std::string& robot) {
    return space.batteries[space.entities.find(robot)][0].used;
  };
  const auto tick = [&simulation](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      simulation.tick();
    }
    return std::get<double>(simulation.metrics().at("f.preys_per_kilojoule"));
  };
  simulation.apply(MoveEntity{"prey_1", {{1.0, 1.0, 0.0}, Eigen::Quaterniond::Identity()}});
  const double before = tick(10);
  const double used = usedBy("fb_1");
  ASSERT_GT(used, 0.0);
  EXPECT_NEAR(before, 1000.0 / (2.0 * used), 1e-9 * before);
  simulation.apply(DeleteEntity{"fb_2"});
  EXPECT_NEAR(tick(10), 1000.0 / (3.0 * used), 1e-9 * before);
  simulation.apply(DeleteEntity{"fb_1"});
  EXPECT_NEAR(tick(1), 1000.0 / (3.0 * used), 1e-9 * before) << "also when nobody is left";
  simulation.reset();
  simulation.apply(MoveEntity{"prey_1", {{1.0, 1.0, 0.0}, Eigen::Quaterniond::Identity()}});
  EXPECT_EQ(tick(10), before) << "a new run has used nothing yet";
}

class ForagingEndTest : public ForagingTest {
 protected:
  ForagingEndTest() : ForagingTest(std::string(kBox) + "<enough>2</enough>") {}
};

TEST_F(ForagingEndTest, EnoughIsASuccess) {
  bring("prey_1", 1.0, 1.0);
  simulation.tick();
  simulation.tick();
  EXPECT_FALSE(simulation.isFinished());
  EXPECT_EQ(simulation.success(), false);
  bring("prey_2", 1.0, 1.0);
  simulation.tick();
  EXPECT_TRUE(simulation.isFinished());
  EXPECT_EQ(simulation.success(), true);
  EXPECT_EQ(ForagingTest::metric("preys"), 2.0);
}

TEST_F(ForagingTest, WithoutEnoughNobodyJudges) {
  bring("prey_1", 1.0, 1.0);
  simulation.tick();
  EXPECT_FALSE(simulation.isFinished());
  EXPECT_EQ(simulation.success(), std::nullopt);
}

TEST(ForagingMistakesTest, AreRefusedWithTheirPlace) {
  const auto refusal = [](const std::string& parameters) -> std::string {
    try {
      const Simulation simulation(foraging(parameters));
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "(accepted)";
  };
  EXPECT_EQ(refusal(std::string(kBox) + "<nest>nets</nest>"),
            "foraging.xml:13: nest: found 'nets', allowed: the id of a floor patch (food, nest); did you mean 'nest'?");
  EXPECT_EQ(refusal("<minimum>2, 2, 0</minimum><maximum>4, 1, 0</maximum>"),
            "foraging.xml:13: maximum: found '4, 1, 0', allowed: nothing below minimum, '2, 2, 0'");
  EXPECT_EQ(refusal(std::string(kBox) + "<prey/>"), "foraging.xml:13: prey: found '', allowed: what names begin with");
  EXPECT_EQ(refusal("<minimum>2, 2, 0</minimum>"), "foraging.xml:13: <foraging> needs <maximum>");
}

}  // namespace
}  // namespace swarmanoid::test
