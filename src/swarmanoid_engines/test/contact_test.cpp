// Robots at contact: they get there, slide, turn, and always come free again.
#include <gtest/gtest.h>

#include <tuple>

#include "world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

using Eigen::Vector3d;

constexpr double kTouching = 1e-9;  // m
constexpr double kTip = 0.11;       // m, of the gripper
constexpr double kWall = 1.95;      // m, where the wall begins

/// No body of the world overlaps another.
void expectNoOverlap(const World& world, Row row, const char* when) {
  const auto& model = *world.space.entities.model[row];
  EXPECT_EQ(world.engine.overlap(model, world.pose(row), row), kNoRow) << when;
}

void tick(World& world, double seconds, int ticks = 1) {
  for (int i = 0; i < ticks; ++i) {
    world.engine.readMirrors(world.space);
    test::carryOut(world.space);
    world.engine.move(world.space, MoveAccess(world.space), std::chrono::nanoseconds(std::llround(1e9 * seconds)));
    world.engine.connect(world.space, ConnectAccess(world.space));
  }
}

TEST(ContactTest, ANoseAtAWallDoesNotKeepARobotFromTurning) {
  // the gripper's corners are 1.8 mm farther out than its tip: the room that a turn needs
  for (double gap = 0.0; gap < 0.0019; gap += 0.00017) {
    for (const double rate : {0.31, -0.31, 2.7}) {
      World world;
      world.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25});
      const Row row = world.addFootbot(flatPose(kWall - kTip - gap, 2.03));
      world.drive(row, 0.0, rate);
      world.step(10);
      EXPECT_NEAR(headingOf(world.pose(row)), rate > M_PI ? rate - 2.0 * M_PI : rate, 1e-9) << gap << " m, " << rate;
      const double start = kWall - kTip - gap;
      const double corner = kWall - std::hypot(kTip, 0.02);
      EXPECT_GE(world.pose(row).position.x(), std::min(corner, start) - kTouching) << "it slips by no more than needed";
      EXPECT_LE(world.pose(row).position.x(), start + kTouching);
      EXPECT_NEAR(world.pose(row).position.y(), 2.03, kTouching);
      expectNoOverlap(world, row, "after turning");
    }
  }
}

TEST(ContactTest, ARobotTurnsInACornerAndLeavesIt) {
  World world;
  world.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25});
  world.addBlock({4.0, 0.1, 0.5}, {1.0, 4.0, 0.25});
  const Row row = world.addFootbot(flatPose(1.5, 3.6, 0.61));
  world.drive(row, 0.23);
  world.step(60);
  expectNoOverlap(world, row, "in the corner");
  EXPECT_GT(world.pose(row).position.x(), kWall - 0.12);
  EXPECT_GT(world.pose(row).position.y(), 3.95 - 0.12);
  const double heading = headingOf(world.pose(row));
  world.drive(row, 0.0, 0.83);
  world.step(30);
  EXPECT_NEAR(std::remainder(headingOf(world.pose(row)) - heading - 2.49, 2.0 * M_PI), 0.0, 0.2)
      << "nearly the whole turn";
  expectNoOverlap(world, row, "turned");
  const Vector3d start = world.pose(row).position;
  world.drive(row, 0.23);
  world.step(20);
  EXPECT_GT((world.pose(row).position - start).norm(), 0.2);
}

TEST(ContactTest, ADiscSlidesAlongAWallWithTheSpeedAlongIt) {
  World world;
  world.addBlock({0.1, 8.0, 0.5}, {2.0, 4.0, 0.25});
  const double heading = 0.645;  // 37 degrees
  const Row row = world.addRobot(discModel(0.1, 0.15), flatPose(kWall - 0.1, 2.0, heading));
  world.drive(row, 0.17);
  world.step(40);
  EXPECT_NEAR(world.pose(row).position.x(), kWall - 0.1, kTouching);
  EXPECT_NEAR(world.pose(row).position.y(), 2.0 + 4.0 * 0.17 * std::sin(heading), 1e-6);
}

TEST(ContactTest, WhatIsFastDoesNotJumpThroughAThinWall) {
  World world;
  world.addBlock({0.004, 4.0, 0.5}, {2.0, 2.0, 0.25});
  const Row row = world.addRobot(discModel(0.1, 0.15), flatPose(1.31, 2.0));
  world.drive(row, 3.1);
  tick(world, 0.2, 3);  // 0.62 m a tick
  EXPECT_NEAR(world.pose(row).position.x(), 1.998 - 0.1, kTouching);
}

TEST(ContactTest, NobodyIsPushedThroughAnother) {
  // a robot between two walls that leave it 1 mm: it cannot turn its nose past them, and stays between them
  World world;
  world.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25});
  world.addBlock({0.1, 4.0, 0.5}, {kWall - kTip - 0.085 - 0.001 - 0.05, 2.0, 0.25});
  const Row row = world.addFootbot(flatPose(kWall - kTip - 0.0005, 2.0));
  world.drive(row, 0.0, 0.4);
  world.step(50);
  expectNoOverlap(world, row, "between two walls");
  const double turned = headingOf(world.pose(row));
  EXPECT_GT(turned, 0.01) << "as far as there is room";
  EXPECT_LT(turned, 0.1);
  EXPECT_NEAR(world.pose(row).position.x(), kWall - kTip - 0.0005, 0.0011);
  world.drive(row, 0.0, -0.4);
  world.step();
  EXPECT_LT(headingOf(world.pose(row)), turned - 0.01) << "and back";
}

TEST(ContactTest, WhoIsPushedOutIsSeenByThoseWhoHadLookedAround) {
  // a robot that turns at a wall slips towards a second robot, which stands still, far from all moving bodies, and
  // drives afterwards
  World world;
  world.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25});
  const Row turning = world.addFootbot(flatPose(kWall - kTip, 2.0));
  const Row behind = world.addRobot(discModel(0.1, 0.15), flatPose(kWall - kTip - 0.085 - 0.1 - 0.003, 2.0));
  world.drive(turning, 0.0, 0.7);
  world.drive(behind, 0.0001);
  for (int i = 0; i < 200; ++i) {
    world.step();
    expectNoOverlap(world, turning, "turning");
    expectNoOverlap(world, behind, "behind");
  }
}

/// Speed [m/s], tick [s].
class ApproachTest : public testing::TestWithParam<std::tuple<double, double>> {
 protected:
  double speed() const { return std::get<0>(GetParam()); }
  double dt() const { return std::get<1>(GetParam()); }

  /// Drives against an obstacle for 3 s, then back. @param x of its origin at contact [m]
  void expectContactAndFreedom(World& world, Row row, double x, const char* what) {
    world.drive(row, speed());
    tick(world, dt(), static_cast<int>(std::ceil(3.0 / dt())));
    EXPECT_NEAR(world.pose(row).position.x(), x, 1e-6) << what;
    expectNoOverlap(world, row, what);
    const Pose at_contact = world.pose(row);
    world.drive(row, 0.0, 0.9);
    tick(world, dt(), static_cast<int>(std::ceil(1.0 / dt())));
    EXPECT_GT(headingOf(world.pose(row)), 0.89) << what;
    world.drive(row, -speed());
    tick(world, dt(), static_cast<int>(std::ceil(1.0 / dt())));
    EXPECT_GT((world.pose(row).position - at_contact.position).norm(), 0.9 * speed()) << what;
    expectNoOverlap(world, row, what);
  }
};

TEST_P(ApproachTest, AWallAPreyAndARobotAreReachedAndLeft) {
  {
    World world;
    world.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25});
    const Row row = world.addFootbot(flatPose(kWall - kTip - 0.0937, 2.0));
    expectContactAndFreedom(world, row, kWall - kTip, "wall");
  }
  {
    World world;
    world.addPrey(0.1, 0.12, 2.0, 2.0);
    const Row row = world.addFootbot(flatPose(1.9 - kTip - 0.0937, 2.0));
    expectContactAndFreedom(world, row, 1.9 - kTip, "prey");
  }
  {
    World world;
    world.addFootbot(flatPose(2.0, 2.0));
    const Row row = world.addFootbot(flatPose(2.0 - 0.085 - kTip - 0.0937, 2.0));
    expectContactAndFreedom(world, row, 2.0 - 0.085 - kTip, "robot");
  }
}

INSTANTIATE_TEST_SUITE_P(SpeedsAndTicks, ApproachTest,
                         testing::Combine(testing::Values(0.05, 0.13, 0.2, 0.3), testing::Values(0.01, 0.1, 0.2)));

}  // namespace
}  // namespace swarmanoid::kinematics2d
