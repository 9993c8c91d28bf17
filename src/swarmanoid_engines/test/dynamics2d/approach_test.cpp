// A robot that approaches an obstacle stops at its surface, at any speed, clocktick and subclock, and comes free again.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <tuple>
#include <vector>

#include "../exact_overlap.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector3d;

constexpr double kDeepest = 0.6e-3;  // m: the limit in engines.md
constexpr double kNear = 1e-3;       // m: counts as contact
constexpr double kTip = 0.11;        // m, of the gripper
constexpr double kWall = 1.95;       // m, where the wall begins

/// Speed [m/s], tick [s], steps in a tick.
class ApproachTest : public testing::TestWithParam<std::tuple<double, double, int>> {
 protected:
  double speed() const { return std::get<0>(GetParam()); }
  double dt() const { return std::get<1>(GetParam()); }

  /// Runs for some seconds, in which nothing may overlap.
  void run(double seconds) {
    const int ticks = static_cast<int>(std::ceil(seconds / dt() - 1e-9));
    for (int i = 0; i < ticks; ++i) {
      world.engine.readMirrors(world.space);
      test::carryOut(world.space);
      world.engine.move(world.space, MoveAccess(world.space), std::chrono::nanoseconds(std::llround(1e9 * dt())));
      world.engine.connect(world.space, ConnectAccess(world.space));
      deepest = std::max(deepest, deepestOverlap(world.space, rows));
    }
  }
  void expectNoOverlap(const char* when) { EXPECT_LE(deepest, kDeepest) << when; }

  /// Drives on towards a round body, which brings the tip of the gripper to its surface. @param radius of `ahead` [m]
  void pushAhead(Row row, Row ahead, double radius) {
    world.drive(row, speed());
    run(3.0);
    expectNoOverlap("at what is ahead");
    const double way = world.pose(ahead).position.x() - world.pose(row).position.x();
    EXPECT_NEAR(way - radius - kTip, 0.0, kNear);
  }

  /// Turns on the spot, then backs off. @param row robot at contact
  /// @param turn that is possible within a second [rad]
  void expectFreedom(Row row, double turn = 0.8) {
    world.drive(row, 0.0, 0.9);
    const double heading = headingOf(world.pose(row));
    run(1.0);
    expectNoOverlap("turning");
    EXPECT_GT(std::remainder(headingOf(world.pose(row)) - heading, 2.0 * M_PI), turn);
    const Vector3d start = world.pose(row).position;
    world.drive(row, -speed());
    run(1.0);
    expectNoOverlap("backing off");
    EXPECT_GT((world.pose(row).position - start).norm(), 0.85 * speed());
  }

  World world{{10.0, 10.0, 2.0}, std::get<2>(GetParam())};
  std::vector<Row> rows;  // all bodies that may overlap
  double deepest = 0.0;   // m, since the start
};

TEST_P(ApproachTest, AWallIsReachedAndLeft) {
  rows.push_back(world.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25}));
  const Row row = world.addFootbot(flatPose(kWall - kTip - 0.0937, 2.0));
  rows.push_back(row);
  world.drive(row, speed());
  run(3.0);
  expectNoOverlap("at the wall");
  EXPECT_NEAR(world.pose(row).position.x(), kWall - kTip, kNear);
  expectFreedom(row);
}

TEST_P(ApproachTest, AConcaveCornerIsReachedAndLeft) {
  rows.push_back(world.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25}));
  rows.push_back(world.addBlock({4.0, 0.1, 0.5}, {1.0, 4.0, 0.25}));
  const Row row = world.addFootbot(flatPose(1.5, 3.6, 0.61));
  rows.push_back(row);
  world.drive(row, speed());
  run(1.0 / speed());
  expectNoOverlap("in the corner");
  EXPECT_GT(world.pose(row).position.x(), kWall - 0.12);
  EXPECT_GT(world.pose(row).position.y(), kWall + 2.0 - 0.12);
  expectFreedom(row, 0.45);  // both walls touch its nose
}

TEST_P(ApproachTest, AConvexCornerIsReachedAndLeft) {
  // the robot's round back approaches the edge of a block at (2, 2) diagonally
  rows.push_back(world.addBlock({0.4, 0.4, 0.5}, {2.2, 2.2, 0.25}));
  const double reach = 0.085 + 0.0937;
  const Row row = world.addFootbot(flatPose(2.0 - reach * std::sqrt(0.5), 2.0 - reach * std::sqrt(0.5), -0.75 * M_PI));
  rows.push_back(row);
  world.drive(row, -speed());
  run(0.0937 / speed() + 0.2);
  expectNoOverlap("at the edge");
  EXPECT_NEAR((world.pose(row).position - Vector3d(2.0, 2.0, 0.0)).norm(), 0.085, kNear);
  world.drive(row, speed());
  run(1.0);
  EXPECT_GT((world.pose(row).position - Vector3d(2.0, 2.0, 0.0)).norm(), 0.085 + 0.85 * speed());
  expectNoOverlap("leaving the edge");
}

TEST_P(ApproachTest, APreyIsReachedPushedAndLeft) {
  const Row prey = world.addPrey(0.1, 0.12, 2.0, 2.0);
  const Row row = world.addFootbot(flatPose(2.0 - 0.1 - kTip - 0.0937, 2.0));
  rows = {prey, row};
  pushAhead(row, prey, 0.1);
  EXPECT_NEAR(world.pose(row).position.x(), 2.0 - 0.1 - kTip - 0.0937 + 3.0 * speed(), 0.05 * speed() + dt() * speed());
  expectFreedom(row);
}

TEST_P(ApproachTest, ARobotThatStandsIsReachedAndLeft) {
  const Row standing = world.addFootbot(flatPose(2.0, 2.0));
  const Row row = world.addFootbot(flatPose(2.0 - 0.085 - kTip - 0.0937, 2.0));
  rows = {standing, row};
  pushAhead(row, standing, 0.085);
  expectFreedom(row);
}

TEST_P(ApproachTest, RobotsMeetHeadOnAndPart) {
  for (const double aside : {0.0, 0.013, 0.031}) {
    rows.clear();
    deepest = 0.0;
    const double y = 2.0 + 50.0 * aside;
    const Row left = world.addFootbot(flatPose(2.0 - kTip - 0.0937, y));
    const Row right = world.addFootbot(flatPose(2.0 + kTip + 0.0811, y + aside, M_PI));
    rows = {left, right};
    world.drive(left, speed());
    world.drive(right, speed());
    run(0.1 / speed() + 0.2);
    expectNoOverlap("head on");
    EXPECT_NEAR((world.pose(right).position - world.pose(left).position).x(), 2.0 * kTip, aside == 0.0 ? kNear : 5e-3);
    world.drive(right, 0.0);
    expectFreedom(left);
    expectFreedom(right);
    world.drive(left, 0.0);
    world.drive(right, 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(SpeedsTicksAndSubclocks, ApproachTest,
                         testing::Combine(testing::Values(0.05, 0.13, 0.2, 0.3), testing::Values(0.01, 0.025, 0.1, 0.2),
                                          testing::Values(1, 4)));

}  // namespace
}  // namespace swarmanoid::dynamics2d
