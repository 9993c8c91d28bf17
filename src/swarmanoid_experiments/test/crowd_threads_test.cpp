// Whole runs of diffusion, crowded and not: any number of threads gives the same bits.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "swarmanoid_space/simulation/simulation.hpp"
#include "swarmanoid_space/testing/diffusion_experiment.hpp"

namespace swarmanoid::test {
namespace {

class CrowdThreadsTest : public testing::TestWithParam<double> {};  // m2 a robot

std::vector<std::uint64_t> hashesOf(double area_per_robot, int threads) {
  constexpr int kRobots = 2500;  // enough for several ranges in each phase
  loadBuiltInPlugins();
  Experiment experiment =
      parseExperiment(diffusionExperiment(kRobots, area_per_robot, "<kinematics2d id='ground'/>"), "crowd.xml");
  experiment.framework.threads = threads;
  Simulation simulation(std::move(experiment));
  simulation.start();
  std::vector<std::uint64_t> hashes;
  for (int tick = 0; tick < 60; ++tick) {
    simulation.tick();
    hashes.push_back(simulation.stateHash());
  }
  return hashes;
}

TEST_P(CrowdThreadsTest, AnyNumberOfThreadsGivesTheSameBits) {
  const std::vector<std::uint64_t> alone = hashesOf(GetParam(), 1);
  for (const int threads : {2, 4, 8}) {
    EXPECT_EQ(hashesOf(GetParam(), threads), alone) << threads << " threads";
  }
}

INSTANTIATE_TEST_SUITE_P(, CrowdThreadsTest, testing::Values(0.1, 1.6));  // crowded as in the benchmarks, and sparse

}  // namespace
}  // namespace swarmanoid::test
