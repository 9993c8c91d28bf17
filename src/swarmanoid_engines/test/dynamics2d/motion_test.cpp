// Motion of unobstructed footbots on their treels.
#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector3d;

struct Case {
  int subclock;
  double start;  // m from the origin, along x and y
};

class MotionTest : public testing::TestWithParam<Case> {
 protected:
  World world{{100.0, 100.0, 2.0}, GetParam().subclock};
  double start = GetParam().start;
};

TEST_P(MotionTest, AStraightLineIsAsLongAsSpeedTimesTime) {
  const double heading = 0.3;
  const Row row = world.addFootbot(flatPose(start, start, heading));
  world.drive(row, 0.1);
  world.step(100);
  const Vector3d way = world.pose(row).position - Vector3d(start, start, 0.0);
  EXPECT_NEAR(way.x() * std::cos(heading) + way.y() * std::sin(heading), 1.0, 1e-3);
  EXPECT_NEAR(way.y() * std::cos(heading) - way.x() * std::sin(heading), 0.0, 1e-3);
  EXPECT_NEAR(headingOf(world.pose(row)), heading, 1e-6);
  EXPECT_NEAR(world.twist(row).linear.norm(), 0.1, 1e-6);
}

TEST_P(MotionTest, AnArcIsThatOfTheCircle) {
  const Row row = world.addFootbot(flatPose(start, start));
  const double speed = 0.1;
  const double turn_rate = 0.3;
  world.drive(row, speed, turn_rate);
  world.step(100);
  const double radius = speed / turn_rate;
  const double angle = 3.0;
  EXPECT_NEAR(headingOf(world.pose(row)), angle, 0.01 * angle);
  EXPECT_NEAR(world.pose(row).position.x() - start, radius * std::sin(angle), 0.01);
  EXPECT_NEAR(world.pose(row).position.y() - start, radius * (1.0 - std::cos(angle)), 0.01);
}

TEST_P(MotionTest, ATurnOnTheSpotStaysThere) {
  const Row row = world.addFootbot(flatPose(start, start));
  world.drive(row, 0.0, 0.5);
  world.step(60);
  EXPECT_NEAR(headingOf(world.pose(row)), 3.0, 0.03);
  EXPECT_NEAR(world.pose(row).position.x(), start, 1e-4);
  EXPECT_NEAR(world.pose(row).position.y(), start, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Subclocks, MotionTest,
                         testing::Values(Case{1, 9.0}, Case{2, 1.0}, Case{5, 50.0}, Case{10, 9.0}, Case{50, 9.0},
                                         Case{50, 50.0}, Case{1, 50.0}));

TEST(SpeedTest, ACommandStepIsFollowedAsFastAsTreelsHold) {
  World world({10.0, 10.0, 2.0}, 50);
  const Row row = world.addFootbot(flatPose(1.0, 1.0));
  world.drive(row, 0.3);
  world.step(1);
  // friction of 0.9 accelerates by 8.8 m/s2: 34 ms until 0.3 m/s
  const double acceleration = 0.9 * kGravity;
  const double way = 0.3 * 0.1 - 0.3 * 0.3 / (2.0 * acceleration);
  EXPECT_NEAR(world.pose(row).position.x() - 1.0, way, 3e-4);
  EXPECT_NEAR(world.twist(row).linear.x(), 0.3, 1e-6);
}

TEST(SpeedTest, APushedOffPreySlidesAsFarAsFrictionSays) {
  World world({10.0, 10.0, 2.0}, 10);
  const Row prey = world.addToSpace(cylindricPreyModel(0.1, 0.1), flatPose(1.0, 1.0));
  world.space.entities.twist[prey].linear = {0.8, 0.0, 0.0};
  test::carryOut(world.space);
  world.engine.add(world.space, prey, Role::kMove);
  world.step(20);
  EXPECT_NEAR(world.pose(prey).position.x() - 1.0, 0.8 * 0.8 / (2.0 * 0.4 * kGravity), 0.01);
  EXPECT_LT(world.twist(prey).linear.norm(), 1e-6);
}

TEST(SpeedTest, WhatWasNotMovedKeepsItsPoseToTheBit) {
  World world;
  const Pose start = flatPose(1.2345678901, 2.3456789012, 0.7);
  const Row footbot = world.addFootbot(start);
  const Row prey = world.add(cylindricPreyModel(0.1, 0.1), flatPose(3.3333333333, 1.1111111111, 0.1));
  const Pose prey_start = world.pose(prey);
  world.step(100);
  EXPECT_EQ(world.pose(footbot).position, start.position);
  EXPECT_EQ(world.pose(footbot).orientation.coeffs(), start.orientation.coeffs());
  EXPECT_EQ(world.pose(prey).position, prey_start.position);
  EXPECT_EQ(world.pose(prey).orientation.coeffs(), prey_start.orientation.coeffs());
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
