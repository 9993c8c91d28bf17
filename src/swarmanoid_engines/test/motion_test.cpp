// Motion of unobstructed bodies at commanded velocities.
#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

class MotionTest : public testing::TestWithParam<int> {};  // by subclock

TEST_P(MotionTest, AStraightLineIsAsLongAsSpeedTimesTime) {
  World world({10.0, 10.0, 2.0}, GetParam());
  const Row row = world.addFootbot(flatPose(1.0, 2.0));
  world.drive(row, 0.1);
  world.step(100);
  EXPECT_NEAR(world.pose(row).position.x(), 2.0, 1e-9);
  EXPECT_NEAR(world.pose(row).position.y(), 2.0, 1e-9);
  EXPECT_NEAR(world.twist(row).linear.x(), 0.1, 1e-9);
  EXPECT_EQ(world.twist(row).angular, Vector3d::Zero());
}

TEST_P(MotionTest, ADiagonalLineKeepsItsHeading) {
  World world({10.0, 10.0, 2.0}, GetParam());
  const Row row = world.addFootbot(flatPose(3.0, 3.0, 2.0));
  const Quaterniond before = world.pose(row).orientation;
  world.drive(row, -0.1);
  world.step(100);
  EXPECT_NEAR(world.pose(row).position.x(), 3.0 - std::cos(2.0), 1e-9);
  EXPECT_NEAR(world.pose(row).position.y(), 3.0 - std::sin(2.0), 1e-9);
  EXPECT_EQ(world.pose(row).orientation.coeffs(), before.coeffs());
}

TEST_P(MotionTest, AnArcEndsWhereTheCircleSays) {
  World world({10.0, 10.0, 2.0}, GetParam());
  const Row row = world.addFootbot(flatPose(5.0, 5.0));
  const double speed = 0.2;
  const double turn_rate = 0.25;
  world.drive(row, speed, turn_rate);
  world.step(100);
  const double radius = speed / turn_rate;
  const double angle = turn_rate * 10.0;
  EXPECT_NEAR(world.pose(row).position.x(), 5.0 + radius * std::sin(angle), 1e-9);
  EXPECT_NEAR(world.pose(row).position.y(), 5.0 + radius * (1.0 - std::cos(angle)), 1e-9);
  EXPECT_NEAR(headingOf(world.pose(row)), angle, 1e-9);
  EXPECT_NEAR(world.twist(row).angular.z(), turn_rate, 1e-9);
  // at the end of the tick the robot moves along its heading
  const Vector3d ahead(std::cos(angle), std::sin(angle), 0.0);
  EXPECT_LT((world.twist(row).linear - speed * ahead).norm(), 1e-9) << world.twist(row).linear.transpose();
}

TEST_P(MotionTest, AHardlyCurvedArcIsAsExact) {
  World world({10.0, 10.0, 2.0}, GetParam());
  const Row row = world.addFootbot(flatPose(5.0, 5.0));
  world.drive(row, 0.2, 1e-7);
  world.step(100);
  EXPECT_NEAR(world.pose(row).position.x(), 7.0, 1e-9);
  EXPECT_NEAR(world.pose(row).position.y(), 5.0 + 0.5 * 1e-7 * 2.0 * 10.0, 1e-9);
}

TEST_P(MotionTest, ManyTurnsOnTheSpotEndAtTheRightHeading) {
  World world({10.0, 10.0, 2.0}, GetParam());
  const Row row = world.addFootbot(flatPose(5.0, 5.0, -1.0));
  world.drive(row, 0.0, 4.0);
  world.step(1000);
  EXPECT_NEAR(world.pose(row).position.x(), 5.0, 1e-12);
  EXPECT_NEAR(std::remainder(headingOf(world.pose(row)) - (400.0 - 1.0), 2.0 * M_PI), 0.0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Subclocks, MotionTest, testing::Values(1, 2, 5, 10, 50));

TEST(EyebotMotionTest, FliesItsVelocityInItsOwnFrameAndStaysInThePlane) {
  World world({10.0, 10.0, 4.0}, 4, "z", 2.0);
  const Row row = world.addToSpace(discModel(0.25, 0.2), flatPose(5.0, 5.0, M_PI / 2.0, 2.0));
  EyebotVelocity& velocity = world.space.actuation.bank<EyebotVelocity>().add(row);
  test::carryOut(world.space);
  world.engine.add(world.space, row, Role::kMove);
  velocity.linear = {0.3, 0.1, 0.5};
  world.step(10);
  EXPECT_TRUE(world.pose(row).position.isApprox(Vector3d(4.9, 5.3, 2.0), 1e-12));
  velocity.linear = {0.0, 0.0, 1.0};
  velocity.yaw_rate = -0.5;
  world.step(10);
  EXPECT_TRUE(world.pose(row).position.isApprox(Vector3d(4.9, 5.3, 2.0), 1e-12));
  EXPECT_NEAR(headingOf(world.pose(row)), M_PI / 2.0 - 0.5, 1e-12);
  EXPECT_NEAR(world.twist(row).angular.z(), -0.5, 1e-9);
  velocity.linear = {0.1, -0.2, 0.0};
  world.step(1);
  const double heading = M_PI / 2.0 - 0.5 - 0.05;
  const Vector3d expected(0.1 * std::cos(heading) + 0.2 * std::sin(heading),
                          0.1 * std::sin(heading) - 0.2 * std::cos(heading), 0.0);
  EXPECT_LT((world.twist(row).linear - expected).norm(), 1e-9) << "sideways too, at the end of the tick";
}

/// A footbot in the plane perpendicular to an axis, its wheels on the plane.
struct OnAWall {
  const char* axis;
  double angle;  // of the body about `tilt`, so that body z is along the axis
  Vector3d tilt;
};

class WallMotionTest : public testing::TestWithParam<OnAWall> {};

TEST_P(WallMotionTest, DrivesAheadAndTurnsToItsLeft) {
  const OnAWall& wall = GetParam();
  const double distance = 0.5;
  World world({10.0, 10.0, 10.0}, 3, wall.axis, distance);
  Pose pose;
  pose.orientation = Quaterniond(AngleAxisd(wall.angle, wall.tilt));
  pose.position = Vector3d::Constant(5.0);
  pose.position[wall.axis[0] - 'x'] = distance;
  ASSERT_EQ(world.engine.invalidPoseReason(*footbotModel(), pose), "");
  const Row row = world.addFootbot(pose);
  const double turn_rate = 0.3;
  world.drive(row, 0.1, turn_rate);
  world.step(20);
  // the same arc in the body's own frame
  const double radius = 0.1 / turn_rate;
  const double angle = 2.0 * turn_rate;
  const Vector3d way(radius * std::sin(angle), radius * (1.0 - std::cos(angle)), 0.0);
  EXPECT_LT((world.pose(row).position - (pose.position + pose.orientation * way)).norm(), 1e-9);
  const Quaterniond turned = pose.orientation * AngleAxisd(angle, Vector3d::UnitZ());
  EXPECT_LT(world.pose(row).orientation.angularDistance(turned), 1e-7);
  EXPECT_LT((world.twist(row).angular - turn_rate * (pose.orientation * Vector3d::UnitZ())).norm(), 1e-9);
  EXPECT_EQ(world.pose(row).position[wall.axis[0] - 'x'], distance);
}

INSTANTIATE_TEST_SUITE_P(Axes, WallMotionTest,
                         testing::Values(OnAWall{"z", 0.7, Vector3d::UnitZ()}, OnAWall{"z", M_PI, Vector3d::UnitX()},
                                         OnAWall{"x", M_PI / 2.0, Vector3d::UnitY()},
                                         OnAWall{"x", -M_PI / 2.0, Vector3d::UnitY()},
                                         OnAWall{"y", M_PI / 2.0, Vector3d::UnitX()},
                                         OnAWall{"y", -M_PI / 2.0, Vector3d::UnitX()}));

TEST(MotionTest, WhatHasNoDriveStandsStill) {
  World world;
  const Row robot = world.add(footbotModel(), flatPose(1.0, 1.0));
  const Row prey = world.addPrey(0.1, 0.1, 2.0, 2.0);
  const Row block = world.addBlock({0.2, 0.2, 0.2}, {3.0, 3.0, 0.1}, 0.4);
  const ByRow<Pose>& now = world.space.entities.pose;
  RowMap<Pose> before;
  for (const Row row : world.space.entities.order) {
    before.fit(row) = now[row];
  }
  world.step(10);
  for (const Row row : {robot, prey, block}) {
    EXPECT_EQ(world.pose(row).position, before[row].position);
    EXPECT_EQ(world.pose(row).orientation.coeffs(), before[row].orientation.coeffs());
    EXPECT_EQ(world.twist(row).linear, Vector3d::Zero());
  }
}

TEST(MotionTest, TwistIsZeroAgainOnceItStops) {
  World world;
  const Row row = world.addFootbot(flatPose(1.0, 1.0));
  world.drive(row, 0.1, 0.2);
  world.step();
  EXPECT_GT(world.twist(row).linear.norm(), 0.05);
  world.drive(row, 0.0);
  world.step();
  EXPECT_EQ(world.twist(row).linear, Vector3d::Zero());
  EXPECT_EQ(world.twist(row).angular, Vector3d::Zero());
}

}  // namespace
}  // namespace swarmanoid::kinematics2d
