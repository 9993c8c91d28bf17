// A steady tick allocates no memory: every malloc (and so every new) of this program is counted.
#include <gtest/gtest.h>

#include <vector>

#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

TEST(AllocationTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  World world({5.0, 5.0, 2.0}, 3);
  for (const double x : {0.0, 5.0}) {
    world.addBlock({0.1, 5.0, 0.5}, {x, 2.5, 0.25});
    world.addBlock({5.0, 0.1, 0.5}, {2.5, x, 0.25});
  }
  std::vector<Row> robots;
  for (int i = 0; i < 100; ++i) {
    robots.push_back(world.addFootbot(flatPose(0.5 + 0.4 * (i % 10), 0.5 + 0.4 * (i / 10), 0.7 * i)));
    world.drive(robots.back(), 0.2, 0.1 * (i % 7 - 3));
  }
  const Row prey = world.addPrey(0.1, 0.12, 0.7, 0.3);
  const Row rocking = world.add(discModel(0.1, 0.5), flatPose(2.5, 4.8), Role::kMirror);
  std::vector<Segment> segments(24);
  std::vector<RayHit> hits(24);
  const auto tick = [&](int i) {
    world.pose(rocking).orientation = Eigen::AngleAxisd(0.3 * std::sin(0.1 * i), Eigen::Vector3d::UnitX());
    world.step();
    for (const Row row : robots) {
      RayBundle bundle;
      bundle.centre = world.pose(row).position;
      bundle.radius = 0.2;
      bundle.ignored = row;
      for (std::size_t k = 0; k < segments.size(); ++k) {
        const double angle = 0.26 * static_cast<double>(k);
        segments[k] = {bundle.centre, bundle.centre + 0.2 * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.1)};
        hits[k] = RayHit{};
      }
      bundle.segments = segments;
      world.engine.raycast(bundle, hits);
    }
  };
  for (int i = 0; i < 200; ++i) {
    tick(i);
  }
  const long before = heap_allocations;
  for (int i = 200; i < 500; ++i) {
    tick(i);
  }
  EXPECT_EQ(heap_allocations - before, 0);
  EXPECT_EQ(world.space.structure.grippedBy(robots[0]), kNoRow);
  EXPECT_GT(before, 100);  // the counting works
  EXPECT_EQ(world.pose(prey).position.z(), 0.0);
}

}  // namespace
}  // namespace swarmanoid::kinematics2d
