// Whole runs of diffusion, crowded and sparse: any number of threads gives the same bits.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_experiment_files/testing/diffusion_experiment.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

struct Crowd {
  double area;       // per robot, m2
  int clocktick_ms;  // with long ticks robots move in several parts when neighbours are near
};

class CrowdThreadsTest : public testing::TestWithParam<Crowd> {};

std::vector<std::uint64_t> hashesOf(const Crowd& crowd, int threads) {
  constexpr int kRobots = 2500;  // enough for several ranges of robots in each phase
  loadBuiltInPlugins();
  Experiment experiment = parseExperiment(
      diffusionExperiment(kRobots, crowd.area, "<kinematics2d id='ground'/>", crowd.clocktick_ms), "crowd.xml");
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

// crowded as in the benchmarks, sparse, and with long ticks
INSTANTIATE_TEST_SUITE_P(, CrowdThreadsTest, testing::Values(Crowd{0.1, 100}, Crowd{1.6, 100}, Crowd{0.3, 630}));

}  // namespace
}  // namespace swarmanoid::test
