// Bodies in steady motion are moved without ODE: with the same results, and only without neighbours.
#include "dynamics3d/steady_motion.hpp"

#include <gtest/gtest.h>

#include "terrains.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kGripperEnd = 0.11;  // m, ahead of a footbot's middle

struct Course {
  double speed;
  double turn_rate;
  double heading;
};

class SteadyMotionTest : public testing::TestWithParam<Course> {};

TEST_P(SteadyMotionTest, GoesWhereOdeWouldTakeIt) {
  const Course course = GetParam();
  World with_ode;
  World without;
  Row rows[2];
  int i = 0;
  for (World* world : {&with_ode, &without}) {
    rows[i] = world->addFootbot(flatPose(4.3, 5.1, course.heading));
    world->drive(rows[i++], course.speed, course.turn_rate);
  }
  with_ode.engine.keepInOde(true);
  with_ode.step(200);
  without.step(200);
  EXPECT_EQ(2000U, with_ode.engine.solverCounts().moved);
  EXPECT_LT(without.engine.solverCounts().moved, 200U);
  const Pose& expected = with_ode.pose(rows[0]);
  const Pose& seen = without.pose(rows[1]);
  EXPECT_LT((expected.position - seen.position).norm(), 2e-5);
  EXPECT_LT(expected.orientation.angularDistance(seen.orientation), 1e-5);
  EXPECT_LT((with_ode.twist(rows[0]).linear - without.twist(rows[1]).linear).norm(), 1e-5);
  EXPECT_NEAR(with_ode.twist(rows[0]).angular.z(), without.twist(rows[1]).angular.z(), 1e-5);
  const WheelTurns& turns = with_ode.space.wheel_turns[rows[0]];
  EXPECT_NEAR(turns.left, without.space.wheel_turns[rows[1]].left, 1e-9);
  EXPECT_NEAR(turns.right, without.space.wheel_turns[rows[1]].right, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Courses, SteadyMotionTest,
                         testing::Values(Course{0.0, 0.0, 0.4}, Course{0.083, 0.0, 1.9}, Course{-0.11, 0.0, -2.7},
                                         Course{0.0, 1.37, 0.2}, Course{0.0, -0.61, 3.0}, Course{0.17, 0.73, -1.1},
                                         Course{0.23, -1.3, 0.9}));

TEST(SteadyMotion, FollowsACommandAtOnce) {
  World world;
  const Row footbot = world.addFootbot(flatPose(4.0, 5.0, 0.6));
  world.drive(footbot, 0.13);
  world.step(40);
  const auto moved = world.engine.solverCounts().moved;
  world.step();
  EXPECT_EQ(moved, world.engine.solverCounts().moved);
  world.drive(footbot, -0.05, 0.8);
  world.step();
  EXPECT_EQ(moved + 10, world.engine.solverCounts().moved);
  world.step(3);
  EXPECT_NEAR(world.twist(footbot).angular.z(), 0.8, 0.01);
}

TEST(SteadyMotion, WhoComesNearMeetsWhatStands) {
  World world;
  const double radius = 0.06;
  const double mass = 0.3;
  const Row prey = world.addPrey(radius, 0.1, mass, 5.0, 5.0);
  const Row footbot = world.addFootbot(flatPose(4.2, 5.0));
  world.drive(footbot, 0.19);
  world.step(20);
  const Vector3d before = world.pose(prey).position;
  world.step(5);
  EXPECT_LT((before - world.pose(prey).position).norm(), 1e-6) << "nobody has touched it";
  for (int i = 0; i < 60; ++i) {
    world.step();
    const double gap = world.pose(prey).position.x() - world.pose(footbot).position.x();
    ASSERT_GT(gap, radius + 0.05) << "tick " << i;
  }
  EXPECT_GT(world.pose(prey).position.x(), 5.3);
  EXPECT_NEAR(world.twist(prey).linear.x(), 0.19, 0.01);
}

TEST(SteadyMotion, TwoThatDriveIntoEachOtherStop) {
  World world;
  const Row left = world.addFootbot(flatPose(4.0, 5.0));
  const Row right = world.addFootbot(flatPose(6.0, 5.02, M_PI));
  world.drive(left, 0.25);
  world.drive(right, 0.25);
  for (int i = 0; i < 60; ++i) {
    world.step();
    const double distance = (world.pose(left).position - world.pose(right).position).norm();
    ASSERT_GT(distance, 2.0 * 0.08) << "tick " << i;
  }
  EXPECT_LT(world.twist(left).linear.norm(), 0.1);
}

TEST(SteadyMotion, AWallStopsIt) {
  World world;
  world.add(blockModel({0.1, 4.0, 0.3}, 0.0), flatPose(6.0, 5.0));
  const Row footbot = world.addFootbot(flatPose(4.0, 5.0));
  world.drive(footbot, 0.27);
  world.step(150);
  EXPECT_NEAR(world.pose(footbot).position.x(), 5.95 - kGripperEnd, 1e-3);
}

TEST(SteadyMotion, AWallAslantConcernsWhoIsNearItOnly) {
  World world;
  world.add(blockModel({8.0, 0.1, 0.3}, 0.0), flatPose(5.0, 5.0, 0.77));
  const Row far = world.addFootbot(flatPose(7.0, 3.0));
  world.step(40);
  const auto moved = world.engine.solverCounts().moved;
  world.step(10);
  EXPECT_EQ(moved, world.engine.solverCounts().moved);
  world.drive(far, 0.21, 0.0);
  world.place(far, flatPose(5.6, 4.4, 0.77 + 0.5 * M_PI));
  world.step(100);
  const Eigen::Vector2d normal(-std::sin(0.77), std::cos(0.77));
  const double distance = -normal.dot((world.pose(far).position - Vector3d(5.0, 5.0, 0.0)).head<2>());
  EXPECT_NEAR(distance, 0.05 + kGripperEnd, 1e-3);
}

TEST(SteadyMotion, GoesOnWhenWhatStoodInItsWayIsGone) {
  World world;
  const Row block = world.add(blockModel({0.1, 0.4, 0.3}, 0.0), flatPose(5.0, 5.0));
  const Row footbot = world.addFootbot(flatPose(4.6, 5.0));
  world.drive(footbot, 0.15);
  world.step(100);
  const double stopped = world.pose(footbot).position.x();
  world.remove(block);
  world.step(20);
  EXPECT_NEAR(world.pose(footbot).position.x() - stopped, 0.15 * 2.0, 0.02);
}

TEST(SteadyMotion, ABoxStandsWhereItCameToRest) {
  World world;
  const Row block = world.addBlock({0.2, 0.3, 0.1}, 0.7, flatPose(3.0, 4.0, 0.8, 0.05));
  world.step(30);
  const Pose before = world.pose(block);
  const auto moved = world.engine.solverCounts().moved;
  world.step(1000);
  EXPECT_EQ(moved, world.engine.solverCounts().moved);
  EXPECT_LT((before.position - world.pose(block).position).norm(), 1e-5);
  world.place(block, flatPose(3.0, 4.0, 0.8, 0.4));
  world.step(8);
  EXPECT_LT(world.pose(block).position.z(), 0.15) << "put elsewhere it falls";
}

TEST(SteadyMotion, OtherParametersAreFeltAtOnce) {
  World world;
  world.addBlock({0.2, 0.3, 0.1}, 0.7, flatPose(3.0, 4.0, 0.8, 0.05));
  world.step(30);
  const auto moved = world.engine.solverCounts().moved;
  world.step();
  ASSERT_EQ(moved, world.engine.solverCounts().moved);
  Configuration heavier("dynamics3d", "", {});
  heavier.set("gravity", "20");
  world.engine.reconfigure(heavier);
  world.step();
  EXPECT_EQ(moved + 10, world.engine.solverCounts().moved);
}

TEST(SteadyMotion, AHoleAheadIsFallenInto) {
  World world;
  world.setTerrain(terrainOf([](double, double) { return -0.4; }, 0.5));
  const Row footbot = world.addFootbot(flatPose(3.0, 5.1));
  world.drive(footbot, 0.22);
  world.step(40);
  EXPECT_NEAR(world.pose(footbot).position.x(), 3.0 + 0.22 * 4.0, 0.01);
  EXPECT_NEAR(world.pose(footbot).position.z(), 0.0, 2e-5);
  world.step(40);
  EXPECT_LT(world.pose(footbot).position.z(), -0.2);
}

TEST(SteadyMotion, WhatHangsOnItFollows) {
  World world;
  const Row prey = world.addPrey(0.06, 0.1, 0.3, 5.15, 5.0);
  const Row footbot = world.addFootbot(flatPose(5.0, 5.0));
  world.setGripper(footbot, true);
  world.step(20);
  ASSERT_EQ(prey, world.gripped(footbot));
  const Vector3d before = world.pose(prey).position;
  world.drive(footbot, -0.1);
  world.step(50);
  EXPECT_NEAR(world.pose(prey).position.x() - before.x(), -0.5, 0.02);
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
