// Whole ticks of the diffusion experiment with dynamics3d (sense, control, move; one thread, no ROS), in turn with ODE
// alone (raw_ode.hpp), whose robots start at the same places and whose wheels get the same commanded speeds. Items are
// robots: items per second are robots x ticks per second; `exact` and `quick` are those of ODE alone with its two
// solvers, `against_library` is our rate divided by that of the faster of the two. Each iteration is a run of kTicks
// ticks from the first one on. Times are processor times.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "diffusion_run.hpp"
#include "raw_ode.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"

namespace swarmanoid::benchmarks {
namespace {

constexpr int kTicks = 50;

/// Processor times of a run [s].
struct Times {
  double ours = 0.0;
  double exact = 0.0;
  double quick = 0.0;
};

/// Whether the robots of ODE alone drive as ours do: otherwise the comparison is meaningless.
bool areDriven(const RawOde& raw, const Space& space, const std::vector<Row>& robots, const std::vector<Pose>& starts) {
  double way = 0.0;
  double apart = 0.0;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const Eigen::Vector3d& ours = space.entities.pose[robots[i]].position;
    way += (ours - starts[i].position).head<2>().norm();
    apart += (raw.position(i) - ours).head<2>().norm();
  }
  return apart < 0.1 * way;
}

/// @param tick [s] @return whether ODE alone has driven the robots to about the same places
bool runInTurn(int count, int subclock, double tick, Times& times) {
  const std::string engine =
      "<dynamics3d id='ground'><subclock>" + std::to_string(subclock) + "</subclock></dynamics3d>";
  const auto simulation = startDiffusion(count, engine, tick);
  const Space& space = simulation->space();
  const std::vector<Row> robots = robotsOf(space);
  std::vector<Pose> starts;
  for (const Row row : robots) {
    starts.push_back(space.entities.pose[row]);
  }
  RawOde exact(space, robots, space.size.x(), RawOde::Solver::kExact);
  RawOde quick(space, robots, space.size.x(), RawOde::Solver::kQuick);
  for (int i = 0; i < kTicks; ++i) {
    const double start = processorSeconds();
    simulation->tick();
    const double ours = processorSeconds();
    exact.setWheelSpeeds(space, robots);
    exact.step(tick, subclock);
    const double middle = processorSeconds();
    quick.setWheelSpeeds(space, robots);
    quick.step(tick, subclock);
    times.ours += ours - start;
    times.exact += middle - ours;
    times.quick += processorSeconds() - middle;
  }
  return areDriven(exact, space, robots, starts) && areDriven(quick, space, robots, starts);
}

void BM_Dynamics3d(benchmark::State& state) {
  const auto robots = static_cast<int>(state.range(0));
  const auto subclock = static_cast<int>(state.range(1));
  constexpr double kStep = 0.01;  // s: the longest that the engine allows
  loadBuiltInPlugins();
  Times times;
  for (auto _ : state) {
    const double before = times.ours;
    if (!runInTurn(robots, subclock, kStep * subclock, times)) {
      state.SkipWithError("ODE alone does not drive the robots to the same places");
      return;
    }
    state.SetIterationTime(times.ours - before);
  }
  const double items = static_cast<double>(state.iterations()) * robots * kTicks;
  state.SetItemsProcessed(state.iterations() * robots * kTicks);
  state.counters["exact"] = items / times.exact;
  state.counters["quick"] = items / times.quick;
  state.counters["against_library"] = std::min(times.exact, times.quick) / times.ours;
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int subclock : {10, 1}) {
    benchmark->Args({10, subclock})->Args({100, subclock})->Args({1000, subclock});
  }
  benchmark->ArgNames({"robots", "subclock"})->UseManualTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(BM_Dynamics3d)->Apply(sizes);

}  // namespace
}  // namespace swarmanoid::benchmarks

BENCHMARK_MAIN();
