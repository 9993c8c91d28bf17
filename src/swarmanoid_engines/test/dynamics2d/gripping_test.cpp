// Grips: rigid, in any structure, until they tear.
#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector3d;

constexpr double kReach = 0.115;  // m from a footbot's centre to the strip it grips

/// Distance between the origins of two entities.
double distance(const World& world, Row a, Row b) { return (world.pose(a).position - world.pose(b).position).norm(); }

TEST(GrippingTest, AGrippedPreyComesAlongAndIsLetGo) {
  World world({10.0, 10.0, 2.0}, 10);
  const Row footbot = world.addFootbot(flatPose(1.0, 1.0));
  const Row prey = world.addPrey(0.1, 0.1, 1.0 + kReach + 0.1, 1.0);
  world.setGripper(footbot, true);
  world.step();
  ASSERT_EQ(world.space.structure.grippedBy(footbot), prey);
  ASSERT_EQ(world.space.events.size(), 1U);
  EXPECT_EQ(world.space.events[0].kind, Event::Kind::kAttached);
  const double apart = distance(world, footbot, prey);
  world.drive(footbot, -0.1, 0.2);
  world.step(100);
  EXPECT_NEAR(distance(world, footbot, prey), apart, 1e-3);
  world.setGripper(footbot, false);
  world.drive(footbot, -0.1);
  world.step(20);
  EXPECT_EQ(world.space.structure.grippedBy(footbot), kNoRow);
  EXPECT_GT(distance(world, footbot, prey), apart + 0.15);
}

TEST(GrippingTest, FootbotsGripFootbotsInAChain) {
  World world({10.0, 10.0, 2.0}, 10);
  constexpr int kCount = 6;
  std::vector<Row> chain;
  for (int i = 0; i < kCount; ++i) {
    chain.push_back(world.addFootbot(flatPose(4.0 - i * (kReach + 0.085), 1.0)));
  }
  for (int i = 1; i < kCount; ++i) {
    world.setGripper(chain[static_cast<std::size_t>(i)], true);
  }
  world.step();
  for (std::size_t i = 1; i < kCount; ++i) {
    EXPECT_EQ(world.space.structure.grippedBy(chain[i]), chain[i - 1]);
  }
  EXPECT_EQ(world.space.structure.root(chain.back()), chain.front());
  const double length = distance(world, chain.front(), chain.back());
  for (const Row row : chain) {
    world.drive(row, 0.1);
  }
  world.step(100);
  EXPECT_NEAR(distance(world, chain.front(), chain.back()), length, 2e-3);
  EXPECT_NEAR(world.pose(chain.front()).position.x(), 5.0, 0.01);
}

TEST(GrippingTest, AChainHangsStraightBehindWhoPullsAlone) {
  World world({10.0, 10.0, 2.0}, 10);
  const Row puller = world.addFootbot(flatPose(3.0, 1.0));
  const Row first = world.addPrey(0.1, 0.1, 3.0 + kReach + 0.1, 1.0, 0.5);
  world.setGripper(puller, true);
  const Row second = world.addFootbot(flatPose(3.0 - kReach - 0.085, 1.0));
  world.setGripper(second, true);
  world.step();
  ASSERT_EQ(world.space.structure.grippedBy(second), puller);
  ASSERT_EQ(world.space.structure.grippedBy(puller), first);
  world.drive(second, -0.1);
  world.drive(puller, -0.1);
  world.step(50);
  EXPECT_NEAR(world.pose(first).position.x(), 3.0 + kReach + 0.1 - 0.5, 0.01);
}

TEST(GrippingTest, ALoopIsRefused) {
  World world({10.0, 10.0, 2.0}, 10);
  const double side = kReach + 0.085;
  // three footbots in a triangle, each facing the next
  const Vector3d corners[] = {
      {1.0, 1.0, 0.0}, {1.0 + side, 1.0, 0.0}, {1.0 + side / 2.0, 1.0 + side * std::sqrt(3.0) / 2.0, 0.0}};
  std::vector<Row> rows;
  for (int i = 0; i < 3; ++i) {
    rows.push_back(world.addFootbot(flatPose(corners[i].x(), corners[i].y(), i * 2.0 * M_PI / 3.0)));
    world.setGripper(rows.back(), true);
  }
  world.step(3);
  int grips = 0;
  for (const Row row : rows) {
    grips += world.space.structure.grippedBy(row) != kNoRow ? 1 : 0;
  }
  EXPECT_EQ(grips, 2);
}

TEST(GrippingTest, TenPullWhatOneCannot) {
  for (const int count : {1, 10}) {
    World world({10.0, 10.0, 2.0}, 10);
    const Row prey = world.addPrey(0.8, 0.1, 5.0, 5.0, 20.0);  // friction of 78 N against 16 N a footbot
    for (int i = 0; i < count; ++i) {
      // on the right half, facing the prey; all drive to the right
      const double angle = count == 1 ? 0.0 : (i - 4.5) * 0.25;
      const double reach = 0.8 + kReach;
      const Row row =
          world.addFootbot(flatPose(5.0 + reach * std::cos(angle), 5.0 + reach * std::sin(angle), angle + M_PI));
      world.setGripper(row, true);
      world.drive(row, -0.1);
    }
    world.step(100);
    if (count == 1) {
      EXPECT_LT(world.pose(prey).position.x(), 5.001);
    } else {
      EXPECT_EQ(world.space.structure.grippersOf(prey).size(), 10U);
      EXPECT_GT(world.pose(prey).position.x(), 5.1);
    }
  }
}

TEST(GrippingTest, AGripTearsAtTheStatedForce) {
  // whirled around on ice, a prey pulls with its mass times the turn rate squared times the radius
  World world = worldWith({{"grip_strength", "5"}, {"treel_friction", "10"}, {"ground_friction", "0"}}, 20);
  const Row footbot = world.addFootbot(flatPose(5.0, 5.0));
  constexpr double kMass = 2.0;
  const double radius = kReach + 0.1;
  const Row prey = world.addPrey(0.1, 0.1, 5.0 + radius, 5.0, kMass);
  world.setGripper(footbot, true);
  world.step();
  double turn_rate = 0.0;
  while (world.space.structure.grippedBy(footbot) == prey && turn_rate < 10.0) {
    turn_rate += 0.01;
    world.drive(footbot, 0.0, turn_rate);
    world.step();
    ASSERT_NEAR((world.pose(footbot).position - Eigen::Vector3d(5.0, 5.0, 0.0)).norm(), 0.0, 0.01) << turn_rate;
  }
  EXPECT_NEAR(kMass * turn_rate * turn_rate * radius, 5.0, 0.25);
}

TEST(GrippingTest, WhatWasTornOffIsGrippedAgainOnlyAfterOpening) {
  World world = worldWith({{"grip_strength", "5"}});
  const Row footbot = world.addFootbot(flatPose(1.0, 1.0));
  const Row prey = world.addPrey(0.1, 0.1, 1.0 + kReach + 0.1, 1.0, 100.0);
  world.setGripper(footbot, true);
  world.step();
  ASSERT_EQ(world.space.structure.grippedBy(footbot), prey);
  world.drive(footbot, -0.01);
  world.step();
  ASSERT_EQ(world.space.events.size(), 1U);
  EXPECT_EQ(world.space.events[0].kind, Event::Kind::kReleased);
  EXPECT_EQ(world.space.events[0].text, "torn off: pulled with more than 5 N");
  world.drive(footbot, 0.0);
  world.step(3);
  EXPECT_EQ(world.space.structure.grippedBy(footbot), kNoRow);
  world.setGripper(footbot, false);
  world.step();
  world.setGripper(footbot, true);
  world.step();
  EXPECT_EQ(world.space.structure.grippedBy(footbot), prey);
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
