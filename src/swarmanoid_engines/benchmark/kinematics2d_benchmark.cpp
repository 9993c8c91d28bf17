// Moving and ray casting of many footbots. Items are robots: items per second are robots x ticks per second.
#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <vector>

#include "../test/world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

constexpr double kSparse = 1.6;  // m2 a robot: diffusion
constexpr double kDense = 0.1;   // m2 a robot: a crowd

/// Footbots at random places without overlap, which drive around.
std::unique_ptr<World> makeCrowd(int count, double area_each, int subclock) {
  const double side = std::sqrt(count * area_each) + 0.3;
  auto world = std::make_unique<World>(Eigen::Vector3d(side, side, 1.0), subclock);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.15, side - 0.15);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < count; ++i) {
    Pose pose = flatPose(place(random), place(random), M_PI * unit(random));
    while (world->engine.overlap(*footbotModel(), pose, kNoRow) != kNoRow) {
      pose = flatPose(place(random), place(random), M_PI * unit(random));
    }
    const Row row = world->addFootbot(pose);
    world->drive(row, 0.1, 0.3 * unit(random));
  }
  for (const double x : {0.0, side}) {
    world->addBlock({0.1, side, 0.5}, {x, side / 2.0, 0.25});
    world->addBlock({side, 0.1, 0.5}, {side / 2.0, x, 0.25});
  }
  return world;
}

void benchmarkMove(benchmark::State& state, double area_each) {
  const int count = static_cast<int>(state.range(0));
  const auto world = makeCrowd(count, area_each, static_cast<int>(state.range(1)));
  std::vector<int> ticks_back(static_cast<std::size_t>(count), 0);
  for (auto _ : state) {
    test::carryOut(world->space);
    world->engine.move(world->space, MoveAccess(world->space), std::chrono::milliseconds(100));
    // blocked robots back off along an arc: otherwise all are stuck in the end
    constexpr double kHardly = 0.02;  // m/s
    for (int i = 0; i < count; ++i) {
      const Row row{i};
      int& back = ticks_back[static_cast<std::size_t>(i)];
      if (back > 0) {
        if (--back == 0) {
          world->drive(row, 0.1, 0.002 * (i % 300 - 150));
        }
      } else if (world->twist(row).linear.norm() < kHardly) {
        world->drive(row, -0.1, 1.0);
        back = 10;
      }
    }
  }
  state.SetItemsProcessed(state.iterations() * count);
}

/// 24 rays of 10 cm from each footbot.
void benchmarkRays(benchmark::State& state, double area_each) {
  const int count = static_cast<int>(state.range(0));
  const auto world = makeCrowd(count, area_each, 1);
  constexpr std::size_t kRays = 24;
  std::vector<Segment> segments(kRays);
  std::vector<RayHit> hits(kRays);
  std::array<Eigen::Vector3d, kRays> ring;
  for (std::size_t k = 0; k < kRays; ++k) {
    const double angle = 2.0 * M_PI * static_cast<double>(k) / kRays;
    ring[k] = {std::cos(angle), std::sin(angle), 0.0};
  }
  world->step();
  for (auto _ : state) {
    for (int i = 0; i < count; ++i) {
      const Row row{i};
      const Pose& pose = world->pose(row);
      const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
      const Eigen::Vector3d sensor = pose.position + Eigen::Vector3d(0.0, 0.0, 0.06);
      for (std::size_t k = 0; k < kRays; ++k) {
        const Eigen::Vector3d way = rotation * ring[k];
        segments[k] = {sensor + 0.085 * way, sensor + 0.185 * way};
        hits[k] = RayHit{};
      }
      RayBundle bundle;
      bundle.segments = segments;
      bundle.centre = pose.position;
      bundle.radius = 0.2;
      bundle.ignored = row;
      world->engine.raycast(bundle, hits);
      benchmark::DoNotOptimize(hits.data());
    }
  }
  state.SetItemsProcessed(state.iterations() * count);
}

/// One bundle of short rays in the open: the cost for a robot without neighbours.
void benchmarkLonelyRays(benchmark::State& state) {
  const int count = static_cast<int>(state.range(0));
  const auto world = makeCrowd(count, kSparse, 1);
  std::vector<Segment> segments(24);
  std::vector<RayHit> hits(24);
  std::vector<Eigen::Vector3d> lonely;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(0.5, world->space.size.x() - 0.5);
  const auto free = discModel(0.25, 0.1);
  while (lonely.size() < 256) {
    const Pose pose = flatPose(place(random), place(random));
    if (world->engine.overlap(*free, pose, kNoRow) == kNoRow) {
      lonely.push_back(pose.position);
    }
  }
  std::size_t i = 0;
  for (auto _ : state) {
    RayBundle bundle;
    bundle.segments = segments;
    bundle.centre = lonely[i];
    bundle.radius = 0.2;
    world->engine.raycast(bundle, hits);
    benchmark::DoNotOptimize(hits.data());
    i = (i + 1) % lonely.size();
  }
  state.SetItemsProcessed(state.iterations());
}

BENCHMARK_CAPTURE(benchmarkMove, sparse, kSparse)
    ->ArgNames({"robots", "subclock"})
    ->Args({10, 1})
    ->Args({1000, 1})
    ->Args({10000, 1})
    ->Args({1000, 10});
BENCHMARK_CAPTURE(benchmarkMove, dense, kDense)
    ->ArgNames({"robots", "subclock"})
    ->Args({10, 1})
    ->Args({1000, 1})
    ->Args({10000, 1});
BENCHMARK_CAPTURE(benchmarkRays, sparse, kSparse)->ArgName("robots")->Arg(10)->Arg(1000)->Arg(10000);
BENCHMARK_CAPTURE(benchmarkRays, dense, kDense)->ArgName("robots")->Arg(10)->Arg(1000)->Arg(10000);
BENCHMARK(benchmarkLonelyRays)->ArgName("robots")->Arg(10)->Arg(1000)->Arg(10000);

}  // namespace
}  // namespace swarmanoid::kinematics2d

BENCHMARK_MAIN();
