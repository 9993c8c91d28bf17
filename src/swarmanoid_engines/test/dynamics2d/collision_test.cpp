// Collisions: momentum, energy, walls, crowds.
#include <box2d/b2_body.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector3d;

/// A puck that slides without friction.
Row addPuck(World& world, double x, double y, const Vector3d& velocity, double mass) {
  const Row row = world.addToSpace(cylindricPreyModel(0.1, 0.1, mass), flatPose(x, y));
  world.space.entities.twist[row].linear = velocity;
  test::carryOut(world.space);
  world.engine.add(world.space, row, Role::kMove);
  return row;
}

struct Sum {
  Vector3d momentum = Vector3d::Zero();
  double energy = 0.0;
};

Sum sumOf(const World& world, const std::vector<Row>& rows) {
  Sum sum;
  for (const Row row : rows) {
    const EntityModel& model = *world.space.entities.model[row];
    const Twist& twist = world.twist(row);
    sum.momentum += model.mass * twist.linear;
    sum.energy += 0.5 * model.mass * twist.linear.squaredNorm() +
                  0.5 * model.inertia(2, 2) * twist.angular.z() * twist.angular.z();
  }
  return sum;
}

TEST(CollisionTest, ElasticPucksKeepMomentumAndEnergy) {
  World world = worldWith({{"ground_friction", "0"}, {"contact_friction", "0"}, {"restitution", "1"}});
  const std::vector<Row> rows = {addPuck(world, 1.0, 1.0, {0.5, 0.0, 0.0}, 1.0),
                                 addPuck(world, 2.0, 1.05, {-0.3, 0.0, 0.0}, 3.0)};
  const Sum before = sumOf(world, rows);
  world.step(30);
  const Sum after = sumOf(world, rows);
  EXPECT_GT((world.twist(rows[0]).linear - Vector3d(0.5, 0.0, 0.0)).norm(), 0.1) << "they should have met";
  EXPECT_NEAR((after.momentum - before.momentum).norm(), 0.0, 1e-6);
  EXPECT_NEAR(after.energy, before.energy, 1e-3 * before.energy);
}

TEST(CollisionTest, AHeadOnElasticImpactSwapsEqualPucks) {
  World world = worldWith({{"ground_friction", "0"}, {"contact_friction", "0"}, {"restitution", "1"}});
  const Row a = addPuck(world, 1.0, 1.0, {0.5, 0.0, 0.0}, 1.0);
  const Row b = addPuck(world, 2.0, 1.0, Vector3d::Zero(), 1.0);
  world.step(30);
  EXPECT_NEAR(world.twist(a).linear.x(), 0.0, 1e-6);
  EXPECT_NEAR(world.twist(b).linear.x(), 0.5, 1e-6);
}

TEST(CollisionTest, AnInelasticImpactLeavesThemTogether) {
  World world = worldWith({{"ground_friction", "0"}, {"contact_friction", "0"}});
  const Row a = addPuck(world, 1.0, 1.0, {0.6, 0.0, 0.0}, 1.0);
  const Row b = addPuck(world, 2.0, 1.0, Vector3d::Zero(), 2.0);
  world.step(40);
  EXPECT_NEAR(world.twist(a).linear.x(), 0.2, 1e-6);
  EXPECT_NEAR(world.twist(b).linear.x(), 0.2, 1e-6);
}

TEST(CollisionTest, WhatIsAtAnotherHeightIsPassed) {
  World world;
  const Row row = world.addFootbot(flatPose(1.0, 1.0));
  world.addBlock({0.2, 2.0, 0.1}, {1.5, 1.0, 0.25});  // a table top, 20 cm above the ground
  world.drive(row, 0.1);
  world.step(100);
  EXPECT_NEAR(world.pose(row).position.x(), 2.0, 1e-3);
}

TEST(CollisionTest, AFootbotStopsAtAWall) {
  World world({10.0, 10.0, 2.0}, 4);
  const Row row = world.addFootbot(flatPose(1.0, 1.0));
  world.addBlock({0.1, 2.0, 0.5}, {1.5, 1.0, 0.25});
  world.drive(row, 0.3);
  world.step(100);
  EXPECT_NEAR(world.pose(row).position.x(), 1.45 - 0.11, 3e-3);  // the gripper's tip is 11 cm ahead
  EXPECT_LT(world.twist(row).linear.norm(), 1e-3);
}

TEST(CollisionTest, WhatPressesOnAnotherSinksInByNoMoreThanTheTolerance) {
  World world({10.0, 10.0, 2.0}, 10);
  const Row prey = world.addPrey(0.1, 0.1, 1.0, 1.0, 1000.0);
  const Row footbot = world.addFootbot(flatPose(1.3, 1.0));
  world.drive(footbot, -0.1);  // backwards, with its round back towards the prey
  world.step(100);
  const double gap = world.pose(footbot).position.x() - world.pose(prey).position.x() - 0.185;
  EXPECT_GT(gap, -0.65e-3);
  EXPECT_LT(gap, 0.1e-3) << "it should press";
}

TEST(CollisionTest, NobodyLeavesThroughAWallAndNothingExplodes) {
  World world({4.0, 4.0, 1.0}, 4);
  for (const double at : {0.0, 4.0}) {
    world.addBlock({0.02, 4.0, 0.5}, {at, 2.0, 0.25});
    world.addBlock({4.0, 0.02, 0.5}, {2.0, at, 0.25});
  }
  std::vector<Row> rows;
  for (int x = 0; x < 16; ++x) {
    for (int y = 0; y < 16; ++y) {
      rows.push_back(world.addFootbot(flatPose(0.25 + 0.232 * x, 0.25 + 0.232 * y, 0.4 * (x + 3 * y))));
    }
  }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> speed(-0.3, 0.3);
  double fastest = 0.0;
  for (int tick = 0; tick < 300; ++tick) {
    if (tick % 10 == 0) {
      for (const Row row : rows) {
        world.drive(row, speed(random), 3.0 * speed(random));
      }
    }
    world.step();
    for (const Row row : rows) {
      const Vector3d& p = world.pose(row).position;
      ASSERT_TRUE(p.x() > 0.05 && p.x() < 3.95 && p.y() > 0.05 && p.y() < 3.95) << p.transpose();
      fastest = std::max(fastest, world.twist(row).linear.norm());
    }
  }
  EXPECT_LT(fastest, 0.6);
}

TEST(CollisionTest, WhatIsFastDoesNotPassThroughThinWalls) {
  World world({10.0, 10.0, 2.0}, 1);
  world.addBlock({0.002, 2.0, 0.5}, {2.0, 1.0, 0.25});
  const Row puck = addPuck(world, 1.0, 1.0, {8.0, 0.0, 0.0}, 1.0);
  world.step(10);
  EXPECT_LT(world.pose(puck).position.x(), 1.91);
}

TEST(CollisionTest, AMirrorThatIsPutUponAFootbotPushesItGentlyAway) {
  World world({10.0, 10.0, 2.0}, 10);
  const Row footbot = world.addFootbot(flatPose(1.0, 1.0));
  const Row mirror = world.add(cylindricPreyModel(0.1, 0.1), flatPose(3.0, 1.0), Role::kMirror);
  world.pose(mirror).position.x() = 1.1;
  double fastest = 0.0;
  double longest_way = 0.0;  // in a tick
  for (int i = 0; i < 50; ++i) {
    const Vector3d before = world.pose(footbot).position;
    world.step();
    fastest = std::max(fastest, world.twist(footbot).linear.norm());
    longest_way = std::max(longest_way, (world.pose(footbot).position - before).norm());
  }
  EXPECT_LT(fastest, 0.5);
  EXPECT_LT(longest_way, 0.3 * 0.1) << "0.3 m/s";
  EXPECT_GT((world.pose(footbot).position - world.pose(mirror).position).norm(), 0.18);
  EXPECT_EQ(world.pose(mirror).position.x(), 1.1);
}

/// The entity of the mirror drives an arc of 0.3 m/s and 1.4 rad/s from the heading 0.4: the chord of the tick ends on
/// the arc.
TEST(CollisionTest, AMirrorComesWhereTheArcOfItsEntityLeads) {
  World world({10.0, 10.0, 2.0}, 10);
  world.space.clocktick = std::chrono::milliseconds(100);
  // the pushed body touches the mirror where the arc ends
  const Row mirror = world.add(cylindricPreyModel(0.1, 0.1), flatPose(1.0, 1.0, 0.4), Role::kMirror);
  const Row prey =
      world.add(cylindricPreyModel(0.1, 0.1), flatPose(1.0 + 0.2 * std::cos(0.9), 1.0 + 0.2 * std::sin(0.9)));
  world.space.entities.twist[mirror] = {{0.3 * std::cos(0.4), 0.3 * std::sin(0.4), 0.0}, {0.0, 0.0, 1.4}};
  world.step();
  const double end = 0.4 + 1.4 * 0.1;
  const double radius = 0.3 / 1.4;
  const Vector3d there(1.0 + radius * (std::sin(end) - std::sin(0.4)), 1.0 - radius * (std::cos(end) - std::cos(0.4)),
                       0.0);
  EXPECT_NEAR((world.pose(prey).position - there).norm(), 0.2, 1e-4);
}

TEST(CollisionTest, AMirrorPushesAsItMoves) {
  World world({10.0, 10.0, 2.0}, 10);
  const Row prey = world.add(cylindricPreyModel(0.1, 0.1), flatPose(1.25, 1.0));
  const Row mirror = world.add(cylindricPreyModel(0.1, 0.1), flatPose(1.0, 1.0), Role::kMirror);
  world.space.entities.twist[mirror].linear = {0.2, 0.0, 0.0};
  for (int i = 0; i < 50; ++i) {
    world.step();
    world.pose(mirror).position.x() += 0.02;
  }
  EXPECT_NEAR(world.pose(prey).position.x(), 2.0 + 0.2, 2e-3);
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
