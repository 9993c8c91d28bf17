// A steady tick of a whole simulation (sensors, controllers, actuators, engine, grips, index, monitor) does not use the
// heap.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

struct Stretch {
  const char* experiment;
  bool with_monitor;  // the run ends with its task; without the monitor it continues
  std::uint64_t first;
  std::uint64_t last;
};

class SteadyTickTest : public testing::TestWithParam<Stretch> {};

TEST_P(SteadyTickTest, AllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  const Stretch& run = GetParam();
  loadBuiltInPlugins();
  std::size_t grips = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Experiment experiment =
        readExperiment(findShared("swarmanoid_experiments", std::string("experiments/") + run.experiment + ".xml"));
    experiment.framework.seed = seed;
    experiment.framework.max_clock = 6000;
    if (!run.with_monitor) {
      experiment.visualisations.clear();
    }
    Simulation simulation(std::move(experiment));
    simulation.start();
    while (simulation.space().tick < run.last && !simulation.isFinished()) {
      const long before = heap_allocations;
      simulation.tick();
      const long after = heap_allocations;
      if (simulation.space().tick > run.first) {
        EXPECT_EQ(after - before, 0) << "seed " << seed << ", tick " << simulation.space().tick;
        grips += simulation.space().events.size();
      }
    }
    EXPECT_GT(simulation.space().tick, run.first + 100) << "long enough to be steady";
  }
  EXPECT_GT(heap_allocations, 1000) << "the counting works";
  EXPECT_EQ(grips > 0, run.with_monitor) << "gripping is among what is counted";
}

INSTANTIATE_TEST_SUITE_P(Experiments, SteadyTickTest,
                         testing::Values(Stretch{"diffusion", false, 1000, 2000},
                                         Stretch{"object_retrieval", false, 1000, 2000},
                                         Stretch{"object_retrieval", true, 100, 6000},
                                         Stretch{"emergent_taxis", false, 100, 250},
                                         Stretch{"flocking", false, 300, 500}),
                         [](const auto& run) {
                           return std::string(run.param.experiment) + (run.param.with_monitor ? "_with_monitor" : "");
                         });

}  // namespace
}  // namespace swarmanoid::test
