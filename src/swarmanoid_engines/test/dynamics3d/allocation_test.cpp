// A steady tick allocates no memory: every malloc (and so every new) of this program is counted.
#include "swarmanoid_interface/testing/count_allocations.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "handbot_world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

TEST(AllocationTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  HandbotWorld world;
  for (const double x : {0.0, 5.0}) {
    world.addBlock({0.1, 5.0, 0.5}, 0.0, flatPose(x, 2.5, 0.0, 0.25));
    world.addBlock({5.0, 0.1, 0.5}, 0.0, flatPose(2.5, x, 0.0, 0.25));
  }
  std::vector<Row> robots;
  for (int i = 0; i < 30; ++i) {
    robots.push_back(world.addFootbot(flatPose(0.8 + 0.7 * (i % 6), 0.8 + 0.7 * (i / 6), 0.7 * i)));
    world.drive(robots.back(), 0.2, 1.0 + 0.1 * (i % 7 - 3));
  }
  world.addPrey(0.1, 0.12, 0.3, 0.8 + 0.25, 0.8);
  world.setGripper(robots[0], true);
  const Row eyebot = world.addEyebot(flatPose(2.5, 2.5, 0.0, 1.0));
  world.flight(eyebot).yaw_rate = 0.3;
  const Row handbot = world.addHandbot(flatPose(4.2, 4.2));
  world.rope(handbot).shot = true;
  world.rope(handbot).winding_speed = 0.01;
  const Row mirror = world.add(cylindricPreyModel(0.1, 0.5), flatPose(2.45, 2.55), Role::kMirror);
  std::array<Segment, 8> segments;
  std::array<RayHit, 8> hits;
  const auto tick = [&](int i) {
    world.pose(mirror).orientation = Eigen::AngleAxisd(0.3 * std::sin(0.1 * i), Eigen::Vector3d::UnitX());
    world.arms(handbot).left.shoulder = -0.5 + 0.5 * std::sin(0.1 * i);
    world.step();
    for (const Row row : robots) {
      RayBundle bundle;
      bundle.centre = world.pose(row).position;
      bundle.radius = 0.5;
      bundle.ignored = row;
      for (std::size_t k = 0; k < segments.size(); ++k) {
        const double angle = 0.78 * static_cast<double>(k);
        segments[k] = {bundle.centre, bundle.centre + 0.5 * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.1)};
        hits[k] = RayHit{};
      }
      bundle.segments = Span<const Segment>(segments.data(), segments.size());
      if (world.engine.mayHit(bundle)) {
        world.engine.raycast(bundle, Span<RayHit>(hits.data(), hits.size()));
      }
    }
  };
  for (int i = 0; i < 150; ++i) {
    tick(i);
  }
  EXPECT_GT(heap_allocations, 100);  // the counting works
  long allocations = 0;
  int steady = 0;
  for (int i = 150; i < 300; ++i) {
    const long before = heap_allocations;
    tick(i);
    if (world.space.events.empty()) {  // events have texts
      allocations += heap_allocations - before;
      ++steady;
    }
  }
  EXPECT_EQ(allocations, 0);
  EXPECT_GT(steady, 140);
  EXPECT_NE(world.gripped(robots[0]), kNoRow);
  EXPECT_TRUE(world.space.attachments.isAttached(handbot));
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
