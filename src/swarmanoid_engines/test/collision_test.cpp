// Where robots stop, in worlds that can be computed by hand.
#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

using Eigen::Vector3d;

constexpr double kTouching = 1e-9;  // m

TEST(CollisionTest, AFootbotStopsWithItsGripperAtTheWallAndCanBackOff) {
  World world;
  world.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25});
  const Row row = world.addFootbot(flatPose(1.0, 2.0));
  world.drive(row, 0.1);
  world.step(100);
  EXPECT_NEAR(world.pose(row).position.x(), 1.95 - 0.11, kTouching);
  EXPECT_EQ(world.twist(row).linear, Vector3d::Zero());
  world.drive(row, -0.1);
  world.step(10);
  EXPECT_NEAR(world.pose(row).position.x(), 1.95 - 0.11 - 0.1, kTouching);
}

TEST(CollisionTest, ItAdvancesToContactWhateverItsStep) {
  World world;
  world.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25});
  const Row row = world.addFootbot(flatPose(1.0 - 0.013, 2.0));
  world.drive(row, 0.3);  // 3 cm a tick: the last one has 2.3 cm left
  world.step(28);
  EXPECT_NEAR(world.pose(row).position.x(), 1.827, kTouching);
  world.step();
  const Pose last = world.pose(row);
  EXPECT_NEAR(last.position.x(), 1.84, kTouching);
  EXPECT_EQ(last.position.y(), 2.0);
  world.drive(row, 0.25);
  world.step(20);
  EXPECT_NEAR(world.pose(row).position.x(), 1.84, kTouching);
  EXPECT_EQ(world.pose(row).orientation.coeffs(), last.orientation.coeffs());
}

TEST(CollisionTest, ARoundRobotSlidesAlongTheWallWhileItTurnsAway) {
  World world;
  world.addBlock({0.1, 8.0, 0.5}, {2.0, 4.0, 0.25});
  const Row row = world.addRobot(discModel(0.1, 0.15), flatPose(1.7, 2.0));
  world.drive(row, 0.1);
  world.step(30);
  const Vector3d at_wall = world.pose(row).position;
  EXPECT_NEAR(at_wall.x(), 1.85, kTouching);
  world.drive(row, 0.1, 0.5);
  world.step(20);
  EXPECT_NEAR(world.pose(row).position.x(), at_wall.x(), kTouching);
  // the part along the wall of the commanded way during the turn: v / w (1 - cos 1)
  EXPECT_NEAR(world.pose(row).position.y(), at_wall.y() + 0.2 * (1.0 - std::cos(1.0)), 1e-6);
  EXPECT_NEAR(headingOf(world.pose(row)), 1.0, 1e-9);
  EXPECT_NEAR(world.twist(row).angular.z(), 0.5, 1e-9);
  world.step(20);  // past a right angle the arc leads away
  EXPECT_LT(world.pose(row).position.x(), at_wall.x() - 0.005);
  EXPECT_GT(world.pose(row).position.y(), at_wall.y() + 0.15);
}

TEST(CollisionTest, HeadOnRobotsMeetInTheMiddle) {
  World world;
  const Row left = world.addRobot(discModel(0.1, 0.15), flatPose(1.0, 2.0));
  const Row right = world.addRobot(discModel(0.1, 0.15), flatPose(1.5, 2.0, M_PI));
  world.drive(left, 0.1);
  world.drive(right, 0.1);
  world.step(40);
  EXPECT_NEAR(world.pose(left).position.x(), 1.15, kTouching);
  EXPECT_NEAR(world.pose(right).position.x(), 1.35, kTouching);
}

TEST(CollisionTest, TheOlderRobotTakesTheGapFirst) {
  for (const bool reversed : {false, true}) {
    World world;
    const Row first = world.addToSpace(discModel(0.1, 0.15), flatPose(1.0, 2.0));
    const Row second = world.addToSpace(discModel(0.1, 0.15), flatPose(1.29, 2.0, M_PI));
    for (const Row row : {reversed ? second : first, reversed ? first : second}) {
      world.space.actuation.bank<FootbotWheels>().add(row);
      test::carryOut(world.space);
      world.engine.add(world.space, row, Role::kMove);
    }
    world.drive(first, 0.5);  // 5 cm a tick; the gap is 9 cm
    world.drive(second, 0.5);
    world.step();
    EXPECT_NEAR(world.pose(first).position.x(), 1.05, 1e-12);
    EXPECT_NEAR(world.pose(second).position.x(), 1.25, kTouching);
  }
}

TEST(CollisionTest, ARobotPassesUnderATableButNotThroughItsLeg) {
  World world;
  world.addBlock({1.0, 2.0, 0.05}, {2.0, 2.0, 0.5});
  world.addBlock({0.05, 0.05, 0.475}, {2.0, 3.0, 0.2375});
  const Row under = world.addFootbot(flatPose(1.0, 2.0));
  const Row at_leg = world.addFootbot(flatPose(1.0, 3.0));
  world.drive(under, 0.1);
  world.drive(at_leg, 0.1);
  world.step(200);
  EXPECT_NEAR(world.pose(under).position.x(), 3.0, kTouching);
  EXPECT_NEAR(world.pose(at_leg).position.x(), 1.975 - 0.11, kTouching);
}

TEST(CollisionTest, OnlyTheShapesAtAHeightMeet) {
  // a sill of 4 cm, which overlaps only part of the gripper's 3.5 to 6.5 cm; a beam from 10 to 12 cm hits the body only
  World world;
  world.addBlock({0.1, 1.0, 0.02}, {2.0, 2.0, 0.11});
  const Row row = world.addFootbot(flatPose(1.5, 2.0));
  world.drive(row, 0.1);
  world.step(100);
  EXPECT_NEAR(world.pose(row).position.x(), 1.95 - 0.085, kTouching);
}

TEST(CollisionTest, ATurnedBlockIsMetWhereItIs) {
  World world;
  world.addBlock({1.0, 1.0, 0.5}, {3.0, 2.0, 0.25}, M_PI / 4.0);  // its corner points at the robot
  const Row row = world.addRobot(discModel(0.1, 0.15), flatPose(2.0, 2.0));
  world.drive(row, 0.01);
  world.step(1000);
  EXPECT_NEAR(world.pose(row).position.x(), 3.0 - std::sqrt(0.5) - 0.1, kTouching);
}

TEST(CollisionTest, PreysAreNotPushed) {
  World world;
  const Row prey = world.addPrey(0.1, 0.12, 2.0, 2.0);
  const Row row = world.addFootbot(flatPose(1.5, 2.0));
  world.drive(row, 0.1);
  world.step(100);
  EXPECT_EQ(world.pose(prey).position, Vector3d(2.0, 2.0, 0.0));
  EXPECT_NEAR(world.pose(row).position.x(), 1.79, kTouching);
}

TEST(CollisionTest, OverlapNamesTheOldestInTheWay) {
  World world;
  const Row first = world.addRobot(discModel(0.1, 0.15), flatPose(1.0, 1.0));
  const Row second = world.addRobot(discModel(0.1, 0.15), flatPose(1.25, 1.0));
  const auto disc = discModel(0.1, 0.15);
  EXPECT_EQ(world.engine.overlap(*disc, flatPose(1.125, 1.0), kNoRow), first);
  EXPECT_EQ(world.engine.overlap(*disc, flatPose(1.125, 1.0), first), second);
  EXPECT_EQ(world.engine.overlap(*disc, flatPose(1.0, 1.2), kNoRow), kNoRow);  // touches
  EXPECT_EQ(world.engine.overlap(*disc, flatPose(1.0, 1.2 - 1e-6), kNoRow), first);
  EXPECT_EQ(world.engine.overlap(*blockModel({0.1, 0.1, 0.1}), flatPose(1.0, 1.0, 0.0, 0.3), kNoRow), kNoRow);
}

TEST(CollisionTest, MirrorsAreObstaclesWhereTheSpaceSaysTheyAre) {
  World world;
  const Row mirror = world.add(discModel(0.1, 0.15), flatPose(8.0, 8.0), Role::kMirror);
  const Row row = world.addRobot(discModel(0.1, 0.15), flatPose(1.0, 2.0));
  world.pose(mirror) = flatPose(1.5, 2.0);
  world.drive(row, 0.1);
  world.step(100);
  EXPECT_NEAR(world.pose(row).position.x(), 1.3, kTouching);
  EXPECT_EQ(world.pose(mirror).position, Vector3d(1.5, 2.0, 0.0));
}

TEST(CollisionTest, WhatAMirrorWasPutUponMayOnlyLeave) {
  World world;
  const Row mirror = world.add(discModel(0.1, 0.15), flatPose(8.0, 8.0), Role::kMirror);
  const Row row = world.addRobot(discModel(0.1, 0.15), flatPose(1.0, 2.0));
  world.pose(mirror) = flatPose(1.1, 2.0);
  world.drive(row, 0.1);
  world.step(10);
  EXPECT_EQ(world.pose(row).position.x(), 1.0);
  world.drive(row, -0.1);
  world.step(10);
  EXPECT_NEAR(world.pose(row).position.x(), 0.9, 1e-12);
}

TEST(CollisionTest, AMirrorThatTiltsIsMetAsItStands) {
  // a post of 1 m that another engine lays down along x
  World world;
  const Row post = world.add(discModel(0.05, 1.0), flatPose(2.0, 2.0), Role::kMirror);
  const Row row = world.addRobot(discModel(0.1, 0.15), flatPose(2.5, 1.0, M_PI / 2.0));
  world.pose(post).orientation = Eigen::AngleAxisd(M_PI / 2.0, Vector3d::UnitY());
  world.drive(row, 0.1);
  world.step(200);
  EXPECT_NEAR(world.pose(row).position.y(), 2.0 - 0.05 - 0.1, 1e-6);
}

}  // namespace
}  // namespace swarmanoid::kinematics2d
