// Contacts of two boxes by this engine's code, alternating with ODE's test of the same geoms. Items are pairs of boxes:
// `against_library` is our throughput over that of ODE. Times are wall-clock times.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "dynamics3d/collision/boxes.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

enum Arrangement { kResting, kFalling, kApart };

/// Pairs of a box and a tilted one below it. @param arrangement resting on it; turned at random and in it; apart from
/// it
std::vector<std::pair<dGeomID, dGeomID>> makePairs(Arrangement arrangement) {
  constexpr int kPairs = 500;
  std::mt19937_64 random(3);
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<std::pair<dGeomID, dGeomID>> pairs;
  for (int i = 0; i < kPairs; ++i) {
    const Vector3d middle(1.0, 2.0, 1.0);
    const Vector3d across = Vector3d(within(-1.0, 1.0), within(-1.0, 1.0), 0.0).normalized();
    const Quaterniond tilt(Eigen::AngleAxisd(within(0.05, 0.5), across));
    const Quaterniond turn(Eigen::AngleAxisd(within(0.0, 6.0), Vector3d(within(-1.0, 1.0), 0.3, 0.4).normalized()));
    const Quaterniond flat(Eigen::AngleAxisd(within(0.0, 6.0), Vector3d::UnitZ()));
    const double height = arrangement == kResting ? 0.099 : (arrangement == kFalling ? 0.15 : 0.32);
    const dGeomID box = dCreateBox(nullptr, 0.2, 0.3, 0.1);
    const dGeomID below = dCreateBox(nullptr, 1.0, 1.0, 0.1);
    setGeomPose(below, middle, tilt);
    setGeomPose(box, middle + tilt * Vector3d(within(-0.3, 0.3), within(-0.3, 0.3), height),
                tilt * (arrangement == kResting ? flat : turn));
    pairs.emplace_back(box, below);
  }
  return pairs;
}

void BM_BoxContacts(benchmark::State& state) {
  constexpr int kMost = 16;
  dInitODE2(0);
  const auto pairs = makePairs(static_cast<Arrangement>(state.range(0)));
  dContactGeom found[kMost];
  double ours = 0.0;
  double library = 0.0;
  const auto seconds = [](auto from, auto to) { return std::chrono::duration<double>(to - from).count(); };
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    for (const auto& [box, below] : pairs) {
      benchmark::DoNotOptimize(collideBoxes(box, below, found));
    }
    const auto middle = std::chrono::steady_clock::now();
    for (const auto& [box, below] : pairs) {
      benchmark::DoNotOptimize(dCollide(box, below, kMost, found, sizeof(dContactGeom)));
    }
    ours += seconds(start, middle);
    library += seconds(middle, std::chrono::steady_clock::now());
    state.SetIterationTime(seconds(start, middle));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(pairs.size()));
  state.counters["against_library"] = library / ours;
  for (const auto& [box, below] : pairs) {
    dGeomDestroy(box);
    dGeomDestroy(below);
  }
}

BENCHMARK(BM_BoxContacts)
    ->ArgName("resting_falling_apart")
    ->DenseRange(kResting, kApart)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace swarmanoid::dynamics3d

BENCHMARK_MAIN();
