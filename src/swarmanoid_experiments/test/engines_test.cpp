// The object retrieval experiment with its footbots and preys in each engine that supports them; the rest is unchanged.
#include <gtest/gtest.h>

#include <algorithm>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

class EnginesTest : public testing::TestWithParam<GroundEngine> {
 protected:
  std::unique_ptr<Simulation> start(std::uint64_t seed, int threads = 1) {
    return retrieval(seed, threads, GetParam());
  }
};

TEST_P(EnginesTest, ThePreyThatWasChosenEndsInTheNest) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const auto simulation = start(seed);
    while (!simulation->isFinished()) {
      simulation->tick();
    }
    EXPECT_EQ(simulation->success(), true) << "seed " << seed;
  }
}

TEST_P(EnginesTest, TheSameSeedGivesTheSameBits) {
  const auto expected = hashesOf(*start(5), 400);
  EXPECT_EQ(hashesOf(*start(5), 400), expected);
  EXPECT_EQ(hashesOf(*start(5, 2), 400), expected) << "on two threads";
}

TEST_P(EnginesTest, AResetIsAFreshStart) {
  const auto expected = hashesOf(*start(6), 6000);
  auto used = start(6);
  hashesOf(*used, expected.size() - 100);  // a prey is being carried by then
  used->reset();
  EXPECT_EQ(hashesOf(*used, 6000), expected);
}

std::string nameOf(const testing::TestParamInfo<GroundEngine>& info) { return info.param.label; }

std::unique_ptr<Simulation> runToEnd(const std::string& experiment) {
  loadBuiltInPlugins();
  auto simulation = std::make_unique<Simulation>(
      readExperiment(findShared("swarmanoid_experiments", "experiments/" + experiment + ".xml")));
  simulation->start();
  while (!simulation->isFinished()) {
    simulation->tick();
  }
  return simulation;
}

TEST(ExampleTest, TenFootbotsPullThePreyIntoTheNest) { EXPECT_EQ(runToEnd("group_pull")->success(), true); }

TEST(ExampleTest, AChainCrossesTheGap) {
  const auto simulation = runToEnd("gap");
  for (int i = 1; i <= 5; ++i) {
    const Eigen::Vector3d& position = poseOf(*simulation, "fb_" + std::to_string(i)).position;
    EXPECT_GT(position.x(), 1.7) << i;
    EXPECT_NEAR(position.z(), 0.4, 2e-3) << i;
  }
}

TEST(ExampleTest, FootbotsWanderOverHillsAndFallIntoAHole) {
  loadBuiltInPlugins();
  Simulation simulation(readExperiment(findShared("swarmanoid_experiments", "experiments/rough_terrain.xml")));
  simulation.start();
  const Space& space = simulation.space();
  ASSERT_NE(space.terrain, nullptr);
  double highest = 0.0;
  while (!simulation.isFinished()) {
    simulation.tick();
    for (const Row row : space.entities.order) {
      const Eigen::Vector3d& position = space.entities.pose[row].position;
      if (!space.entities.model[row]->is_movable) {
        continue;
      }
      const bool is_on_terrain = space.terrain->contains(position.x(), position.y());
      const double ground = is_on_terrain ? space.terrain->heightAt(position.x(), position.y()) : 0.0;
      ASSERT_GT(position.z(), ground - 0.03) << space.entities.name[row] << ", tick " << space.tick;
      ASSERT_EQ(space.outside[row], 0) << space.entities.name[row] << ", tick " << space.tick;
      highest = space.entities.model[row]->is_robot ? std::max(highest, position.z()) : highest;
    }
  }
  EXPECT_GT(highest, 0.1);
  int in_hole = 0;
  for (const Row row : space.entities.order) {
    in_hole += space.entities.pose[row].position.z() < -0.05 ? 1 : 0;
  }
  EXPECT_GE(in_hole, 1);
}

TEST(EngineStepsTest, StepsThatAreTooLongAreRefusedAtLoad) {
  try {
    retrieval(1, 1, {"dynamics3d", 5});
    FAIL() << "it was not refused";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("dynamics3d 'ground': subclock: found 5 with ticks of 100 ms, which makes steps of 20 ms; "
                        "allowed: steps of at most 10 ms, here a subclock from 10"),
              std::string::npos)
        << error.what();
  }
}

INSTANTIATE_TEST_SUITE_P(All, EnginesTest,
                         testing::Values(GroundEngine{"kinematics2d", 1}, GroundEngine{"dynamics2d", 4},
                                         GroundEngine{"dynamics3d", 10}),
                         nameOf);

}  // namespace
}  // namespace swarmanoid::test
