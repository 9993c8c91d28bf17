#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

using Eigen::Vector3d;

/// A footbot at (2, 2) facing a prey whose strip is `gap` from the gripper's tip.
struct Pair {
  explicit Pair(double gap, int subclock = 1) : world({10.0, 10.0, 2.0}, subclock) {
    footbot = world.addFootbot(flatPose(2.0, 2.0));
    prey = world.addPrey(0.1, 0.12, 2.0 + 0.11 + gap + 0.1, 2.0);
  }
  Row gripped() const { return world.space.structure.grippedBy(footbot); }

  World world;
  Row footbot;
  Row prey;
};

TEST(GrippingTest, AClosedGripperTakesThePreyInFrontOfIt) {
  Pair pair(0.015);
  pair.world.step();
  EXPECT_EQ(pair.gripped(), kNoRow);  // still open
  pair.world.setGripper(pair.footbot, true);
  pair.world.step();
  EXPECT_EQ(pair.gripped(), pair.prey);
  ASSERT_EQ(pair.world.space.events.size(), 1U);
  EXPECT_EQ(pair.world.space.events[0].kind, Event::Kind::kAttached);
  EXPECT_EQ(pair.world.space.events[0].entity, "e1");
  EXPECT_EQ(pair.world.space.events[0].other, "e2");
  pair.world.step();
  EXPECT_TRUE(pair.world.space.events.empty());  // reported once
}

TEST(GrippingTest, BeyondTwoCentimetresItIsOutOfReach) {
  Pair pair(0.021);
  pair.world.setGripper(pair.footbot, true);
  pair.world.step();
  EXPECT_EQ(pair.gripped(), kNoRow);
}

TEST(GrippingTest, OpeningLetsGo) {
  Pair pair(0.01);
  pair.world.setGripper(pair.footbot, true);
  pair.world.step();
  pair.world.setGripper(pair.footbot, false);
  pair.world.step();
  EXPECT_EQ(pair.gripped(), kNoRow);
  ASSERT_EQ(pair.world.space.events.size(), 1U);
  EXPECT_EQ(pair.world.space.events[0].kind, Event::Kind::kReleased);
  pair.world.drive(pair.footbot, -0.1);
  const Vector3d before = pair.world.pose(pair.prey).position;
  pair.world.step(10);
  EXPECT_EQ(pair.world.pose(pair.prey).position, before);
}

TEST(GrippingTest, TheRelativePoseDoesNotDrift) {
  for (const int subclock : {1, 5}) {
    Pair pair(0.01, subclock);
    World& world = pair.world;
    world.setGripper(pair.footbot, true);
    world.step();
    const auto relative = [&] {
      const Pose& gripper = world.pose(pair.footbot);
      return Vector3d(gripper.orientation.conjugate() * (world.pose(pair.prey).position - gripper.position));
    };
    const Vector3d at_first = relative();
    world.drive(pair.footbot, 0.1, 0.37);
    world.step(1000);
    EXPECT_LT((relative() - at_first).norm(), 1e-14);
    EXPECT_NEAR(std::remainder(headingOf(world.pose(pair.prey)) - headingOf(world.pose(pair.footbot)), 2.0 * M_PI), 0.0,
                1e-14);
    EXPECT_NEAR(world.twist(pair.prey).angular.z(), 0.37, 1e-9);
    EXPECT_GT(world.twist(pair.prey).linear.norm(), 0.1);
  }
}

TEST(GrippingTest, WhatIsCarriedStopsItsCarrier) {
  Pair pair(0.0);
  World& world = pair.world;
  world.addBlock({0.1, 4.0, 0.5}, {3.0, 2.0, 0.25});
  world.setGripper(pair.footbot, true);
  world.step();
  world.drive(pair.footbot, 0.1);
  world.step(100);
  EXPECT_NEAR(world.pose(pair.prey).position.x(), 2.85, 1e-9);
  EXPECT_NEAR(world.pose(pair.footbot).position.x(), 2.85 - 0.21, 1e-9);
}

TEST(GrippingTest, WhatWasLetGoIsInTheWayAtOnce) {
  Pair pair(0.0);
  World& world = pair.world;
  world.setGripper(pair.footbot, true);
  world.step();
  world.drive(pair.footbot, 0.1);
  world.step(20);
  world.setGripper(pair.footbot, false);
  world.step();
  const Vector3d prey = world.pose(pair.prey).position;
  const Vector3d footbot = world.pose(pair.footbot).position;
  world.step(20);
  EXPECT_EQ(world.pose(pair.prey).position, prey);
  EXPECT_EQ(world.pose(pair.footbot).position, footbot);
}

TEST(GrippingTest, TheNearestIsTakenAndThenTheOldest) {
  World world;
  const Row footbot = world.addFootbot(flatPose(2.0, 2.0));
  // two preys beside the tip at (2.11, 2): the second is nearer
  world.addPrey(0.03, 0.12, 2.11 + 0.005, 2.0 + 0.045);
  const Row nearer = world.addPrey(0.03, 0.12, 2.11 + 0.005, 2.0 - 0.04);
  world.setGripper(footbot, true);
  world.step();
  EXPECT_EQ(world.space.structure.grippedBy(footbot), nearer);

  World tie;
  const Row other = tie.addFootbot(flatPose(2.0, 2.0));
  const Row older = tie.addPrey(0.03, 0.12, 2.125, 2.0 + 0.04);
  tie.addPrey(0.03, 0.12, 2.125, 2.0 - 0.04);
  tie.setGripper(other, true);
  tie.step();
  EXPECT_EQ(tie.space.structure.grippedBy(other), older);
}

TEST(GrippingTest, OnePreyHasOneGripper) {
  Pair pair(0.01);
  World& world = pair.world;
  const Row late = world.addFootbot(flatPose(2.0 + 2.0 * 0.22, 2.0, M_PI));
  world.setGripper(pair.footbot, true);
  world.setGripper(late, true);
  world.step();
  EXPECT_EQ(pair.gripped(), pair.prey);
  EXPECT_EQ(world.space.structure.grippedBy(late), kNoRow);
  world.setGripper(pair.footbot, false);
  world.step();
  EXPECT_EQ(world.space.structure.grippedBy(late), pair.prey);
}

TEST(GrippingTest, FootbotsAreNotGripped) {
  World world;
  const Row gripper = world.addFootbot(flatPose(2.0, 2.0));
  const Row other = world.addFootbot(flatPose(2.2, 2.0));
  world.setGripper(gripper, true);
  world.setGripper(other, true);
  world.step();
  EXPECT_EQ(world.space.structure.grippedBy(gripper), kNoRow);
  EXPECT_EQ(world.space.structure.grippedBy(other), kNoRow);
}

/// A robot without wheels, with a gripper and a strip.
std::shared_ptr<const EntityModel> wheellessModel() {
  auto model = std::make_shared<EntityModel>(*footbotModel());
  model->wheels.reset();
  return model;
}

TEST(GrippingTest, ARobotWithoutADriveIsGrippedOneThatFliesIsNot) {
  for (const bool flies : {false, true}) {
    World world;
    const Row gripper = world.addFootbot(flatPose(2.0, 2.0));
    const Row other = world.addToSpace(wheellessModel(), flatPose(2.205, 2.0));
    world.space.flight[other].is_driven = flies;
    world.engine.add(world.space, other, Role::kMove);
    world.setGripper(gripper, true);
    world.step();
    EXPECT_EQ(world.space.structure.grippedBy(gripper), flies ? kNoRow : other);
    world.space.structure.connect(gripper, other);  // another engine may allow it
    EXPECT_EQ(world.engine.unsupportedStateReason(world.space, gripper),
              flies ? "grips the robot 'e2', which this engine cannot hold" : "");
  }
}

TEST(GrippingTest, ThereAreNoChains) {
  for (const bool is_first_gripped_first : {true, false}) {
    World world;
    const Row first = world.addFootbot(flatPose(2.0, 2.0));
    const Row middle = world.addRobot(wheellessModel(), flatPose(2.205, 2.0));
    const Row prey = world.addPrey(0.1, 0.12, 2.205 + 0.22, 2.0);
    world.setGripper(is_first_gripped_first ? first : middle, true);
    world.step();
    world.setGripper(first, true);
    world.setGripper(middle, true);
    world.step();
    EXPECT_EQ(world.space.structure.grippedBy(first), is_first_gripped_first ? middle : kNoRow);
    EXPECT_EQ(world.space.structure.grippedBy(middle), is_first_gripped_first ? kNoRow : prey);
    world.space.structure.connect(first, middle);
    world.space.structure.connect(middle, prey);
    EXPECT_EQ(world.engine.unsupportedStateReason(world.space, first),
              "grips 'e2' while that grips something, which this engine cannot hold");
    EXPECT_EQ(world.engine.unsupportedStateReason(world.space, middle), "");
  }
}

TEST(GrippingTest, APreyLowerThanTheGripperIsOutOfReach) {
  World world;
  const Row footbot = world.addFootbot(flatPose(2.0, 2.0));
  world.addPrey(0.1, 0.045, 2.22, 2.0);
  world.setGripper(footbot, true);
  world.step();
  EXPECT_EQ(world.space.structure.grippedBy(footbot), kNoRow);
}

TEST(GrippingTest, WorksOnAWall) {
  const Eigen::Quaterniond feet_on_wall(Eigen::AngleAxisd(-M_PI / 2.0, Vector3d::UnitY()));  // body x is up
  World world({10.0, 10.0, 10.0}, 1, "x", 3.0);
  const Row footbot = world.addFootbot({{3.0, 5.0, 5.0}, feet_on_wall});
  const Row prey = world.add(cylindricPreyModel(0.1, 0.12), {{3.0, 5.0, 5.22}, feet_on_wall});
  world.setGripper(footbot, true);
  world.step();
  ASSERT_EQ(world.space.structure.grippedBy(footbot), prey);
  world.drive(footbot, 0.1);
  world.step(10);
  EXPECT_LT((world.pose(prey).position - Vector3d(3.0, 5.0, 5.32)).norm(), 1e-9);
}

TEST(GrippingTest, ARemovedPreyIsForgotten) {
  Pair pair(0.01);
  World& world = pair.world;
  world.setGripper(pair.footbot, true);
  world.step();
  world.remove(pair.prey);
  world.drive(pair.footbot, 0.1);
  world.step(10);
  EXPECT_NEAR(world.pose(pair.footbot).position.x(), 2.1, 1e-9);
  const Row another = world.addPrey(0.1, 0.12, 2.32, 2.0);
  world.drive(pair.footbot, 0.0);
  world.step();
  EXPECT_EQ(pair.gripped(), another);
}

TEST(GrippingTest, WhatIsPutElsewhereIsLetGo) {
  Pair pair(0.01);
  World& world = pair.world;
  world.setGripper(pair.footbot, true);
  world.step();
  world.space.structure.isolate(pair.prey);
  world.pose(pair.prey) = flatPose(5.0, 5.0);
  world.engine.place(world.space, pair.prey);
  world.drive(pair.footbot, 0.1);
  world.step(10);
  EXPECT_EQ(world.pose(pair.prey).position, Vector3d(5.0, 5.0, 0.0));
}

TEST(GrippingTest, GripsComeAlongIntoAnotherEngine) {
  Pair pair(0.01);
  World& world = pair.world;
  world.setGripper(pair.footbot, true);
  world.step();
  for (const Row row : {pair.footbot, pair.prey}) {
    world.engine.remove(world.space, row);
  }
  for (const Row row : {pair.prey, pair.footbot}) {
    test::carryOut(world.space);
    world.engine.add(world.space, row, Role::kMove);
  }
  world.drive(pair.footbot, 0.1);
  world.step(10);
  EXPECT_NEAR(world.pose(pair.prey).position.x(), 2.22 + 0.1, 1e-9);
  world.setGripper(pair.footbot, false);
  world.step();
  EXPECT_EQ(pair.gripped(), kNoRow);
}

}  // namespace
}  // namespace swarmanoid::kinematics2d
