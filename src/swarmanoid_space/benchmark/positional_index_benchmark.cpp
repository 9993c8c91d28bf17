// Range queries among 10^2 to 10^5 entities at constant density: the time of one query must not grow with their number.
#include <benchmark/benchmark.h>

#include <cmath>

#include "swarmanoid_interface/random.hpp"
#include "swarmanoid_space/index/positional_index.hpp"

namespace swarmanoid {
namespace {

struct Scattered {
  Entities entities;
  PositionalIndex index;
  double side;

  Scattered(std::size_t count, PositionalIndex::Optimization optimization)
      : side(std::sqrt(static_cast<double>(count))) {
    const auto model = blockModel({0.2, 0.2, 0.2});
    RandomStream random(1, "benchmark", "place");
    const double height = optimization == PositionalIndex::Optimization::k3D ? 4.0 : 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const Pose pose{{random.uniform(0, side), random.uniform(0, side), random.uniform(0, height + 1e-9)},
                      Eigen::Quaterniond::Identity()};
      entities.add("e" + std::to_string(i), model, pose, colors::kBlack);
    }
    index.configure({side, side, height + 1.0}, optimization, count);
    index.rebuild(entities);
  }
};

void query(benchmark::State& state, PositionalIndex::Optimization optimization) {
  const Scattered world(static_cast<std::size_t>(state.range(0)), optimization);
  RandomStream random(2, "benchmark", "query");
  std::vector<Row> found;
  for (auto _ : state) {
    found.clear();
    world.index.collect({random.uniform(0, world.side), random.uniform(0, world.side), 0.5}, 1.0, found);
    benchmark::DoNotOptimize(found.data());
  }
}

void BM_Query2D(benchmark::State& state) { query(state, PositionalIndex::Optimization::k2D); }
void BM_Query3D(benchmark::State& state) { query(state, PositionalIndex::Optimization::k3D); }

void BM_Rebuild(benchmark::State& state) {
  Scattered world(static_cast<std::size_t>(state.range(0)), PositionalIndex::Optimization::k2D);
  for (auto _ : state) {
    world.index.rebuild(world.entities);
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK(BM_Query2D)->RangeMultiplier(10)->Range(100, 100000);
BENCHMARK(BM_Query3D)->RangeMultiplier(10)->Range(100, 100000);
BENCHMARK(BM_Rebuild)->RangeMultiplier(10)->Range(100, 100000);

}  // namespace
}  // namespace swarmanoid

BENCHMARK_MAIN();
