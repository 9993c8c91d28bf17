// Crowds under pressure start each tick from the contact forces of the last one.
#include "dynamics2d/solver/crowd_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

BodyNumbers bodies(std::uint32_t a, std::uint32_t b) { return {EntityNumber{a}, EntityNumber{b}}; }

ContactConstraint contactWith(std::uint32_t shapes, double impulse, double rub) {
  ContactConstraint contact;
  contact.shapes = shapes;
  contact.points[0].impulse = impulse;
  contact.points[0].rub = rub;
  return contact;
}

TEST(CrowdMemoryTest, RecallsForcesForAnyLengthOfAStep) {
  CrowdMemory memory;
  memory.keep(bodies(7, 9), contactWith(1, 0.3, -0.06), 0.02);
  memory.keep(bodies(2, 30), contactWith(0, 0.5, 0.0), 0.02);
  memory.keep(bodies(7, 9), contactWith(0, 0.1, 0.02), 0.02);
  memory.finishTick();
  std::vector<ContactConstraint> found;
  memory.recall(bodies(7, 9), 4, 0.05, found);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].shapes, 0U);
  EXPECT_EQ(found[1].shapes, 1U);
  EXPECT_EQ(found[1].pair, 4);
  EXPECT_NEAR(found[1].points[0].impulse, 15.0 * 0.05, 1e-12);
  EXPECT_NEAR(found[1].points[0].rub, -3.0 * 0.05, 1e-12);
  memory.recall(bodies(9, 7), 5, 0.05, found);
  memory.recall(bodies(7, 30), 6, 0.05, found);
  EXPECT_EQ(found.size(), 2U) << "other bodies have no forces";
}

TEST(CrowdMemoryTest, ForgetsAfterOneTick) {
  CrowdMemory memory;
  memory.keep(bodies(1, 2), contactWith(0, 1.0, 0.0), 0.1);
  memory.finishTick();
  memory.finishTick();
  std::vector<ContactConstraint> found;
  memory.recall(bodies(1, 2), 0, 0.1, found);
  EXPECT_TRUE(found.empty());
}

/// A column of robots that press against a wall, along no axis, in a corridor: free columns buckle.
class ColumnTest : public testing::TestWithParam<int> {};

TEST_P(ColumnTest, StandsStill) {
  constexpr double kHeading = 0.83;  // rad
  constexpr double kApart = 0.1705;  // m, between robots: half a millimetre is free
  constexpr double kWidth = 0.1702;  // m
  constexpr double kLength = 18.0;   // m
  const int count = GetParam();
  const Eigen::Vector2d forwards(std::cos(kHeading), std::sin(kHeading));
  const Eigen::Vector2d wall(14.0, 15.5);
  World world({30.0, 30.0, 1.0});
  world.add(blockModel({0.2, 1.0, 0.5}), flatPose(wall.x(), wall.y(), kHeading));
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector2d middle =
        wall - 0.5 * kLength * forwards + side * (0.5 * kWidth + 0.05) * Eigen::Vector2d(-forwards.y(), forwards.x());
    world.add(blockModel({kLength, 0.1, 0.5}), flatPose(middle.x(), middle.y(), kHeading));
  }
  std::vector<Row> robots;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector2d place = wall - (0.186 + kApart * i) * forwards;
    robots.push_back(world.addFootbot(flatPose(place.x(), place.y(), kHeading)));
  }
  const auto tick = [&] {
    for (const Row row : robots) {
      world.drive(row, 0.21, 0.0);
    }
    world.step();
  };
  for (int i = 0; i < 200; ++i) {
    tick();
  }
  double fastest = 0.0;  // m/s
  for (int i = 0; i < 20; ++i) {
    tick();
    for (const Row row : robots) {
      fastest = std::max(fastest, world.twist(row).linear.norm());
    }
  }
  EXPECT_LT(fastest, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Columns, ColumnTest, testing::Values(12, 25, 40));

}  // namespace
}  // namespace swarmanoid::dynamics2d
