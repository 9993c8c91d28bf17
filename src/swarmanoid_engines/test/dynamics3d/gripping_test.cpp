// Grips as rigid joints: which bodies can be gripped, how strongly, and what many grippers do together.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kTip = 0.11;            // m, of a footbot's gripper
constexpr double kFootbotStrip = 0.085;  // m, the radius at which a footbot is gripped

/// A footbot at (2, 2) facing a prey whose strip is `gap` from the gripper's tip.
struct Pair {
  explicit Pair(double gap, double mass = 0.3, World::Values values = {}) : world(values) {
    footbot = world.addFootbot(flatPose(2.0, 2.0));
    prey = world.addPrey(0.1, 0.12, mass, 2.0 + kTip + gap + 0.1, 2.0);
  }
  Row gripped() const { return world.gripped(footbot); }

  World world;
  Row footbot = kNoRow;
  Row prey = kNoRow;
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

TEST(GrippingTest, APreyLowerThanTheGripperIsOutOfReach) {
  World world;
  const Row footbot = world.addFootbot(flatPose(2.0, 2.0));
  world.addPrey(0.1, 0.045, 0.3, 2.22, 2.0);
  world.setGripper(footbot, true);
  world.step();
  EXPECT_EQ(world.gripped(footbot), kNoRow);
}

TEST(GrippingTest, ThePreyComesAlongWithoutDrifting) {
  Pair pair(0.01);
  World& world = pair.world;
  world.setGripper(pair.footbot, true);
  world.step();
  const auto relative = [&] {
    const Pose& gripper = world.pose(pair.footbot);
    return Vector3d(gripper.orientation.conjugate() * (world.pose(pair.prey).position - gripper.position));
  };
  const Vector3d at_first = relative();
  world.drive(pair.footbot, -0.1, 0.4);
  world.step(200);
  EXPECT_LT((relative() - at_first).norm(), 1e-4);
  EXPECT_NEAR(world.twist(pair.footbot).angular.z(), 0.4, 0.02);
  EXPECT_NEAR(world.twist(pair.prey).angular.z(), 0.4, 0.02);
}

TEST(GrippingTest, OpeningLetsGo) {
  Pair pair(0.01);
  World& world = pair.world;
  world.setGripper(pair.footbot, true);
  world.step();
  world.setGripper(pair.footbot, false);
  world.step();
  EXPECT_EQ(pair.gripped(), kNoRow);
  ASSERT_EQ(world.space.events.size(), 1U);
  EXPECT_EQ(world.space.events[0].kind, Event::Kind::kReleased);
  EXPECT_EQ(world.space.events[0].text, "");
  world.drive(pair.footbot, -0.1);
  world.step(10);
  EXPECT_NEAR(world.pose(pair.prey).position.x(), 2.22, 1e-4);
  EXPECT_NEAR(world.pose(pair.footbot).position.x(), 1.9, 5e-3);
}

TEST(GrippingTest, FootbotsHandbotsAndPreysAreGrippedByAnyNumber) {
  World world;
  const Row prey = world.addPrey(0.1, 0.12, 0.3, 2.0, 2.0);
  std::vector<Row> grippers;
  for (const double angle : {0.0, 2.0, 4.0}) {
    grippers.push_back(world.addFootbot(flatPose(2.0 - 0.215 * std::cos(angle), 2.0 - 0.215 * std::sin(angle), angle)));
  }
  const Row chained = world.addFootbot(flatPose(2.0 - 0.215 - kFootbotStrip - kTip - 0.005, 2.0));
  const Row handbot = world.add(robotModel("handbot"), flatPose(5.0, 5.0));
  const Row climber = world.addFootbot(flatPose(5.0, 5.0 - 0.145 - kTip - 0.005, M_PI / 2.0));
  for (const Row row : {grippers[0], grippers[1], grippers[2], chained, climber}) {
    world.setGripper(row, true);
  }
  world.step();
  for (const Row row : grippers) {
    EXPECT_EQ(world.gripped(row), prey);
  }
  EXPECT_EQ(world.gripped(chained), grippers[0]);
  EXPECT_EQ(world.gripped(climber), handbot);
  EXPECT_EQ(world.space.structure.members(prey).size(), 5U);
  world.step(20);
  EXPECT_LT((world.pose(prey).position - Vector3d(2.0, 2.0, 0.0)).norm(), 1e-4);
}

TEST(GrippingTest, ALoopIsRefused) {
  World world;
  const double distance = kTip + kFootbotStrip + 0.01;
  // each faces the middle of the next one's side: a ring of four
  std::vector<Row> ring;
  const double half = distance / 2.0;
  const double corners[4][2] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
  for (int i = 0; i < 4; ++i) {
    ring.push_back(world.addFootbot(flatPose(3.0 + corners[i][0], 3.0 + corners[i][1], i * M_PI / 2.0)));
    world.setGripper(ring.back(), true);
  }
  world.step(2);
  int grips = 0;
  for (const Row row : ring) {
    grips += world.gripped(row) != kNoRow ? 1 : 0;
  }
  EXPECT_EQ(grips, 3);
}

/// A footbot that pulls a prey whose friction on the ground is a share of the grip's strength.
struct PulledPair : Pair {
  static constexpr double kStrength = 10.0;  // N
  explicit PulledPair(double share)
      : Pair(0.01, share * kStrength / (0.5 * kGravity), {{"friction", "0.5"}, {"grip_strength", "10"}}) {
    world.setGripper(footbot, true);
    world.step();
    world.drive(footbot, -0.02);
  }
};

TEST(GrippingTest, AGripHoldsUpToItsStrength) {
  PulledPair pair(0.9);
  pair.world.step(50);
  EXPECT_EQ(pair.gripped(), pair.prey);
  EXPECT_NEAR(pair.world.pose(pair.prey).position.x(), 2.22 - 0.1, 0.01);
}

TEST(GrippingTest, AGripBreaksBeyondItsStrengthAndMustBeOpenedFirst) {
  PulledPair pair(1.05);
  World& world = pair.world;
  int ticks = 0;
  std::string why;
  for (; ticks < 50 && why.empty(); ++ticks) {
    world.step();
    for (const Event& event : world.space.events) {
      why = event.kind == Event::Kind::kReleased ? event.text : "";
    }
  }
  EXPECT_EQ(why, "torn off: pulled with more than 10 N");
  EXPECT_EQ(pair.gripped(), kNoRow);
  world.drive(pair.footbot, 0.0);
  world.step(5);
  EXPECT_EQ(pair.gripped(), kNoRow);  // still closed, and the prey within reach
  world.setGripper(pair.footbot, false);
  world.step();
  world.setGripper(pair.footbot, true);
  world.step();
  EXPECT_EQ(pair.gripped(), pair.prey);
}

TEST(GrippingTest, WhatPushesOnAfterTheGripBrokeDoesNotComeIn) {
  for (const char* strength : {"4", "5.5", "7"}) {
    Pair pair(0.007, 20.0, {{"grip_strength", strength}});
    World& world = pair.world;
    world.setGripper(pair.footbot, true);
    world.step();
    ASSERT_EQ(pair.gripped(), pair.prey);
    world.drive(pair.footbot, 0.3);
    double nearest = 1.0;
    for (int i = 0; i < 10; ++i) {
      world.step();
      nearest = std::min(nearest, (world.pose(pair.prey).position - world.pose(pair.footbot).position).norm());
    }
    EXPECT_EQ(pair.gripped(), kNoRow);
    EXPECT_GT(nearest, kTip + 0.1 - 1e-3) << "torn off at " << strength << " N";
  }
}

/// A footbot and a prey of its weight that turn around each other without gravity, joined by a grip.
/// @return whether the grip lasts
bool holdsAgainst(double force) {
  constexpr double kDistance = 0.21;  // m
  World world({{"gravity", "0"}, {"ground", "false"}, {"subclock", "100"}});
  const auto footbot_model = robotModel("footbot");
  const double height = 2.0 * footbot_model->centre_of_mass.z();
  const Row footbot = world.addToSpace(footbot_model, flatPose(2.0, 2.0));
  const Row prey =
      world.addToSpace(cylindricPreyModel(0.1, height, footbot_model->mass), flatPose(2.0 + kDistance, 2.0));
  const double turn_rate = std::sqrt(force / (footbot_model->mass * kDistance / 2.0));
  world.twist(footbot) = {{0.0, -turn_rate * kDistance / 2.0, 0.0}, {0.0, 0.0, turn_rate}};
  world.twist(prey) = {{0.0, turn_rate * kDistance / 2.0, 0.0}, {0.0, 0.0, turn_rate}};
  world.space.actuation.bank<FootbotGripper>().add(footbot);
  world.setGripper(footbot, true);
  EXPECT_TRUE(world.space.structure.connect(footbot, prey));
  test::carryOut(world.space);
  world.engine.add(world.space, footbot, Role::kMove);
  test::carryOut(world.space);
  world.engine.add(world.space, prey, Role::kMove);
  world.step(5);
  return world.gripped(footbot) == prey;
}

TEST(GrippingTest, AGripBreaksAtItsStrength) {
  EXPECT_TRUE(holdsAgainst(0.97 * 50.0));
  EXPECT_FALSE(holdsAgainst(1.03 * 50.0));
}

TEST(GrippingTest, TenFootbotsPullWhatOneCannot) {
  constexpr double kPreyRadius = 0.5;
  const double mass = 5.0 * 0.9 * 1.8 / 0.5;  // kg: its friction is the traction of five footbots
  const auto pulledBy = [&](int columns, int links) {
    World world({{"friction", "0.5"}});
    const Row prey = world.addPrey(kPreyRadius, 0.12, mass, 5.0, 5.0);
    std::vector<Row> footbots;
    for (int column = 0; column < columns; ++column) {
      const double y = 0.2 * (column - (columns - 1) / 2.0);
      double x = -std::sqrt(kPreyRadius * kPreyRadius - y * y) - kTip - 0.005;
      for (int link = 0; link < links; ++link) {
        footbots.push_back(world.addFootbot(flatPose(5.0 + x, 5.0 + y)));
        world.setGripper(footbots.back(), true);
        x -= kFootbotStrip + kTip + 0.005;
      }
    }
    world.step();
    for (const Row row : footbots) {
      EXPECT_NE(world.gripped(row), kNoRow);
      world.drive(row, -0.1);
    }
    world.step(20);
    return 5.0 - world.pose(prey).position.x();
  };
  EXPECT_LT(pulledBy(1, 1), 0.002);
  EXPECT_NEAR(pulledBy(5, 2), 0.2, 0.02);
}

TEST(GrippingTest, ARemovedPreyIsForgotten) {
  Pair pair(0.01);
  World& world = pair.world;
  world.setGripper(pair.footbot, true);
  world.step();
  world.remove(pair.prey);
  world.drive(pair.footbot, 0.1);
  world.step(10);
  EXPECT_NEAR(world.pose(pair.footbot).position.x(), 2.1, 5e-3);
  const Row another = world.addPrey(0.1, 0.12, 0.3, world.pose(pair.footbot).position.x() + 0.23, 2.0);
  world.drive(pair.footbot, 0.0);
  world.step(2);
  EXPECT_EQ(pair.gripped(), another);
}

TEST(GrippingTest, WhatIsPutElsewhereIsLetGo) {
  Pair pair(0.01);
  World& world = pair.world;
  world.setGripper(pair.footbot, true);
  world.step();
  world.place(pair.prey, flatPose(5.0, 5.0));
  world.drive(pair.footbot, 0.1);
  world.step(10);
  EXPECT_LT((world.pose(pair.prey).position - Vector3d(5.0, 5.0, 0.0)).norm(), 1e-4);
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
  world.drive(pair.footbot, -0.1);
  world.step(10);
  EXPECT_NEAR(world.pose(pair.prey).position.x(), 2.22 - 0.1, 5e-3);
  world.setGripper(pair.footbot, false);
  world.step();
  EXPECT_EQ(pair.gripped(), kNoRow);
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
