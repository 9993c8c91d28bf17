// A steady tick allocates no memory: every malloc of this program is counted.
#include <gtest/gtest.h>

#include <vector>

#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

TEST(AllocationTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  World world({5.0, 5.0, 2.0}, 4);
  for (const double x : {0.0, 5.0}) {
    world.addBlock({0.1, 5.0, 0.5}, {x, 2.5, 0.25});
    world.addBlock({5.0, 0.1, 0.5}, {2.5, x, 0.25});
  }
  std::vector<Row> robots;
  for (int i = 0; i < 100; ++i) {
    robots.push_back(world.addFootbot(flatPose(0.5 + 0.4 * (i % 10), 0.5 + 0.4 * (i / 10), 0.7 * i)));
  }
  world.addPrey(0.1, 0.12, 0.7, 0.3);
  const Row mirror = world.add(discModel(0.1, 0.5), flatPose(2.5, 4.8), Role::kMirror);
  const auto tick = [&](int i) {
    world.pose(mirror).position.y() = 4.8 - 0.3 * std::sin(0.1 * i);
    for (const Row row : robots) {
      world.drive(row, i / 40 % 2 == 0 ? 0.2 : -0.1, 0.1 * (static_cast<int>(row) % 7 - 3));
    }
    world.step();
  };
  for (int i = 0; i < 800; ++i) {
    tick(i);
  }
  const long before = heap_allocations;
  for (int i = 800; i < 1200; ++i) {
    tick(i);
  }
  EXPECT_EQ(heap_allocations - before, 0);
  EXPECT_GT(before, 100);  // the counting works
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
