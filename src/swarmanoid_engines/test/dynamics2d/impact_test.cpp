// No tunnelling, however fast and thin bodies are; and bodies rest where their surfaces meet.
#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <vector>

#include "../exact_overlap.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector3d;

constexpr double kDeepest = 0.6e-3;  // m: the limit in engines.md

void tick(World& world, double seconds) {
  world.engine.readMirrors(world.space);
  test::carryOut(world.space);
  world.engine.move(world.space, MoveAccess(world.space), std::chrono::nanoseconds(std::llround(1e9 * seconds)));
  world.engine.connect(world.space, ConnectAccess(world.space));
}

Row addEyebot(World& world, double x, double y, double heading = 0.0) {
  const Row row = world.addToSpace(robotModel("eyebot"), flatPose(x, y, heading));
  world.space.actuation.bank<EyebotVelocity>().add(row);
  test::carryOut(world.space);
  world.engine.add(world.space, row, Role::kMove);
  return row;
}

void fly(World& world, Row row, double speed) {
  world.space.actuation.bank<EyebotVelocity>().find(row)->linear = {speed, 0.0, 0.0};
}

double radiusOf(Row row, const World& world) {
  double radius = 0.0;
  for (const planar::PlanarShape& shape : placedShapes(world.space, row)) {
    radius = std::max(radius, shape.isCircle() ? shape.radius : 0.0);
  }
  return radius;
}

TEST(ImpactTest, AFastEyebotIsStoppedByAThinWall) {
  for (const double dt : {0.2, 0.1, 0.025}) {
    for (const double offset : {0.0, 0.13, 0.31}) {
      World world({12.0, 10.0, 4.0}, 1);
      const Row wall = world.addBlock({0.004, 4.0, 3.0}, {8.0, 2.0, 0.0});
      const Row eyebot = addEyebot(world, 2.0 + offset, 2.0);
      fly(world, eyebot, 3.0);
      for (double time = 0.0; time < 4.0; time += dt) {
        tick(world, dt);
        ASSERT_LE(overlapOf(world.space, wall, eyebot), kDeepest);
        ASSERT_LT(world.pose(eyebot).position.x(), 8.0);
      }
      EXPECT_GT(radiusOf(eyebot, world), 0.0);
      EXPECT_LT(world.twist(eyebot).linear.norm(), 0.01) << "it hovers at the wall";
      EXPECT_GT(world.pose(eyebot).position.x(), 7.0);
    }
  }
}

TEST(ImpactTest, FastEyebotsDoNotPassThroughEachOther) {
  for (const double aside : {0.0, 0.07}) {
    World world({12.0, 10.0, 4.0}, 1);
    const Row left = addEyebot(world, 2.0, 2.0);
    const Row right = addEyebot(world, 9.7, 2.0 + aside, M_PI);
    fly(world, left, 3.0);
    fly(world, right, 3.0);
    bool have_met = false;
    for (int i = 0; i < 15; ++i) {
      tick(world, 0.2);
      ASSERT_LE(overlapOf(world.space, left, right), kDeepest);
      const Vector3d way = world.pose(right).position - world.pose(left).position;
      have_met = have_met || way.norm() < 2.0 * radiusOf(left, world) + 1e-3;
      if (std::abs(way.y()) < 0.1) {
        ASSERT_GT(way.x(), 0.0) << "tick " << i;
      }
    }
    EXPECT_TRUE(have_met);
  }
}

TEST(ImpactTest, AFastRobotIsStoppedByAThinWall) {
  for (const double dt : {0.2, 0.1, 0.01}) {
    World world({10.0, 10.0, 2.0}, 1);
    const Row wall = world.addBlock({0.004, 4.0, 0.5}, {2.0, 2.0, 0.25});
    const Row row = world.addRobot(discModel(0.1, 0.15), flatPose(1.31, 2.0));
    world.drive(row, 3.1);
    for (double time = 0.0; time < 1.0; time += dt) {
      tick(world, dt);
      ASSERT_LE(overlapOf(world.space, wall, row), kDeepest);
    }
    EXPECT_NEAR(world.pose(row).position.x(), 1.998 - 0.1, 0.2e-3);
  }
}

TEST(ImpactTest, BodiesRestWhereTheirSurfacesMeet) {
  for (const double thickness : {0.001, 0.004, 0.1}) {
    for (const double angle : {0.0, 0.41}) {  // polygon against polygon, both turned
      World world({10.0, 10.0, 2.0}, 4);
      const Vector3d ahead(std::cos(angle), std::sin(angle), 0.0);
      const Vector3d start(2.0, 2.0, 0.0);
      const Vector3d middle = start + (0.11 + 0.03 + 0.5 * thickness) * ahead;
      world.addBlock({thickness, 1.0, 0.5}, {middle.x(), middle.y(), 0.25}, angle);
      const Row row = world.addFootbot(flatPose(start.x(), start.y(), angle));
      world.drive(row, 0.1);
      world.step(20);
      EXPECT_NEAR((world.pose(row).position - start).dot(ahead), 0.03, 0.2e-3) << thickness << " " << angle;
    }
  }
}

TEST(ImpactTest, WhatIsHeldStopsAtAWallToo) {
  for (const int subclock : {1, 4, 10}) {
    World world({10.0, 10.0, 2.0}, subclock);
    const Row wall = world.addBlock({0.1, 4.0, 0.5}, {3.0, 2.0, 0.25});
    const Row footbot = world.addFootbot(flatPose(2.2, 2.03));
    const Row prey = world.addPrey(0.1, 0.12, 2.2 + 0.215, 2.03);
    world.setGripper(footbot, true);
    world.step();
    ASSERT_EQ(world.space.structure.grippedBy(footbot), prey);
    world.drive(footbot, 0.2);
    for (int i = 0; i < 60; ++i) {
      world.step();
      ASSERT_LE(overlapOf(world.space, wall, prey), kDeepest) << subclock << ", tick " << i;
      const double apart = (world.pose(prey).position - world.pose(footbot).position).norm();
      ASSERT_NEAR(apart, 0.215, 1.5e-3) << subclock << ", tick " << i;
    }
    EXPECT_NEAR(world.pose(prey).position.x(), 2.95 - 0.1, 1e-3);
    EXPECT_EQ(world.space.structure.grippedBy(footbot), prey) << "the blow does not tear it";
  }
}

TEST(ImpactTest, NobodyIsDeepInAnybodyInACrowdThatJams) {
  for (const int subclock : {1, 4}) {
    World world({2.2, 2.2, 1.0}, subclock);
    std::vector<Row> rows;
    for (const double at : {0.0, 2.2}) {
      rows.push_back(world.addBlock({0.02, 2.2, 0.5}, {at, 1.1, 0.25}));
      rows.push_back(world.addBlock({2.2, 0.02, 0.5}, {1.1, at, 0.25}));
    }
    std::vector<Row> robots;
    for (int x = 0; x < 8; ++x) {
      for (int y = 0; y < 8; ++y) {
        robots.push_back(world.addFootbot(flatPose(0.25 + 0.232 * x, 0.25 + 0.232 * y, 0.4 * (x + 3 * y))));
      }
    }
    rows.insert(rows.end(), robots.begin(), robots.end());
    std::mt19937 random(11);
    std::uniform_real_distribution<double> speed(-0.3, 0.3);
    for (int i = 0; i < 120; ++i) {
      for (std::size_t k = 0; i % 10 == 0 && k < robots.size(); ++k) {
        world.drive(robots[k], speed(random), 3.0 * speed(random));
      }
      world.step();
      if (i % 4 == 3) {
        ASSERT_LE(deepestOverlap(world.space, rows), kDeepest) << subclock << ", tick " << i;
      }
    }
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
