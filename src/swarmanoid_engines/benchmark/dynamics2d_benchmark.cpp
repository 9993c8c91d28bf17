// Whole ticks of the diffusion experiment with dynamics2d (sense, control, move; one thread, no ROS), in turn with
// Box2D alone (raw_box2d.hpp), whose robots start at the same places and get the same velocities. Items are robots:
// items per second are robots x ticks per second; `disc` and `disc_and_box` are those of Box2D alone, `against_library`
// is our rate divided by that of `disc_and_box`. Each iteration is a run of 100 ticks from the first one on, without
// the start, which `BM_Start` measures. Times are processor times.
#include <benchmark/benchmark.h>

#include "diffusion_run.hpp"
#include "raw_box2d.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"

namespace swarmanoid::benchmarks {
namespace {

constexpr int kTicks = 100;
constexpr double kTick = 0.1;  // s

std::string engineWith(int subclock) {
  return "<dynamics2d id='ground'><subclock>" + std::to_string(subclock) + "</subclock></dynamics2d>";
}

/// Processor times of a run [s].
struct Times {
  double ours = 0.0;
  double disc = 0.0;
  double disc_and_box = 0.0;
};

void runInTurn(int count, int subclock, Times& times) {
  const auto simulation = startDiffusion(count, engineWith(subclock), kTick);
  const Space& space = simulation->space();
  const std::vector<Row> robots = robotsOf(space);
  const double side = space.size.x();
  RawBox2d disc(space, robots, side, RawRobot::kDisc);
  RawBox2d disc_and_box(space, robots, side, RawRobot::kDiscAndBox);
  for (int i = 0; i < kTicks; ++i) {
    const double start = processorSeconds();
    simulation->tick();
    const double ours = processorSeconds();
    disc.setVelocities(space, robots);
    disc.step(kTick, subclock);
    const double middle = processorSeconds();
    disc_and_box.setVelocities(space, robots);
    disc_and_box.step(kTick, subclock);
    times.ours += ours - start;
    times.disc += middle - ours;
    times.disc_and_box += processorSeconds() - middle;
  }
}

void BM_Dynamics2d(benchmark::State& state) {
  const auto robots = static_cast<int>(state.range(0));
  loadBuiltInPlugins();
  Times times;
  for (auto _ : state) {
    const double before = times.ours;
    runInTurn(robots, static_cast<int>(state.range(1)), times);
    state.SetIterationTime(times.ours - before);
  }
  const double items = static_cast<double>(state.iterations()) * robots * kTicks;
  state.SetItemsProcessed(state.iterations() * robots * kTicks);
  state.counters["disc"] = items / times.disc;
  state.counters["disc_and_box"] = items / times.disc_and_box;
  state.counters["against_library"] = times.disc_and_box / times.ours;
}

/// Time from the experiment file to the end of the first tick.
void BM_Start(benchmark::State& state) {
  loadBuiltInPlugins();
  for (auto _ : state) {
    startDiffusion(static_cast<int>(state.range(0)), engineWith(4), kTick)->tick();
  }
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int subclock : {4, 10, 1}) {
    benchmark->Args({10, subclock})->Args({1000, subclock})->Args({10000, subclock});
  }
  benchmark->ArgNames({"robots", "subclock"})->UseManualTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(BM_Dynamics2d)->Apply(sizes);
BENCHMARK(BM_Start)->ArgName("robots")->Arg(2500)->Arg(5000)->Arg(10000)->Arg(20000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace swarmanoid::benchmarks

BENCHMARK_MAIN();
