// Whole ticks of the diffusion experiment, one thread, no ROS: robots x ticks per second (items_per_second).
//
// Sparse: one footbot on each 1.6 square metres; dense: one on each 0.1. 24 proximity rays of 10 cm, tick 100 ms,
// subclock 1, collision shapes of thesis figure 3.9.
#include <benchmark/benchmark.h>

#include "swarmanoid_space/simulation/simulation.hpp"
#include "swarmanoid_space/testing/diffusion_experiment.hpp"

namespace swarmanoid {
namespace {

void diffuse(benchmark::State& state, double area_per_robot) {
  const auto robots = static_cast<int>(state.range(0));
  loadBuiltInPlugins();
  Simulation simulation(
      parseExperiment(diffusionExperiment(robots, area_per_robot, "<kinematics2d id='ground'/>"), "diffusion.xml"));
  simulation.start();
  constexpr int kWarmUp = 50;
  for (int i = 0; i < kWarmUp; ++i) {
    simulation.tick();
  }
  for (auto _ : state) {
    simulation.tick();
  }
  state.SetItemsProcessed(state.iterations() * robots);
}

void BM_DiffusionSparse(benchmark::State& state) { diffuse(state, 1.6); }
void BM_DiffusionDense(benchmark::State& state) { diffuse(state, 0.1); }

BENCHMARK(BM_DiffusionSparse)->Arg(10)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_DiffusionDense)->Arg(1000)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace swarmanoid

BENCHMARK_MAIN();
