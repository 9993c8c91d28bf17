// Motion on rough ground: Coulomb's and Newton's laws on slopes, footbots, holes, long runs.
#include <gtest/gtest.h>

#include <vector>

#include "slope.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "terrains.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

double flat(double, double) { return 0.0; }

/// Pitch of a footbot: angle of its x axis above the horizontal [rad].
double pitchOf(const Pose& pose) { return std::asin((pose.orientation * Vector3d::UnitX()).z()); }

/// A terrain that is a tilted plane.
struct TerrainSlope : Slope {
  TerrainSlope(double angle, double direction, World::Values values) : Slope(std::move(values)) {
    const double rise = std::tan(angle);
    const Vector3d across(std::cos(direction), std::sin(direction), 0.0);
    world.setTerrain(terrainOf(
        [&](double x, double y) { return 3.0 - rise * ((x - 5.0) * across.x() + (y - 5.0) * across.y()); }, 0.1, 2.0));
    putBlock({5.0, 5.0, 3.0}, Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitZ().cross(across))), across);
  }
};

class TerrainSlopeTest : public testing::TestWithParam<double> {};

TEST_P(TerrainSlopeTest, ABlockSlidesFromTheFrictionAngleOn) {
  expectToSlideFromTheFrictionAngleOn<TerrainSlope>(GetParam() * kDegree, 3e-4, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Directions, TerrainSlopeTest, testing::Values(0.0, 90.0, 180.0, 30.0, 45.0, -60.0));

TEST(RoughGroundTest, AFootbotDrivesOnAFlatFieldAsOnTheGround) {
  for (const double heading : {0.0, 0.3, -2.0}) {
    World world;
    world.setTerrain(terrainOf(&flat, 0.04));
    const Vector3d along(std::cos(heading), std::sin(heading), 0.0);
    const Vector3d start = Vector3d(5.0, 5.0, 0.0) - 0.5 * along;
    const Row footbot = world.addFootbot(flatPose(start.x(), start.y(), heading));
    world.drive(footbot, 0.1);
    world.step(100);
    const Vector3d way = Eigen::AngleAxisd(-heading, Vector3d::UnitZ()) * (world.pose(footbot).position - start);
    EXPECT_NEAR(way.x(), 1.0, 5e-3);
    EXPECT_NEAR(way.y(), 0.0, 5e-3);
    EXPECT_NEAR(way.z(), 0.0, 1e-4);
    EXPECT_NEAR(headingOf(world.pose(footbot)), heading, 0.5 * kDegree);
  }
}

TEST(RoughGroundTest, AFootbotPassesTheRimOfAFlatFieldUnmoved) {
  World world;
  world.setTerrain(terrainOf(&flat, 0.05));
  const Row footbot = world.addFootbot(flatPose(3.5, 5.0));
  world.drive(footbot, 0.1);
  for (int tick = 0; tick < 100; ++tick) {
    world.step();
    ASSERT_LT(std::abs(world.pose(footbot).position.z()), 1e-4) << "tick " << tick;
    ASSERT_LT(tiltOf(world.pose(footbot)), 5e-3) << "tick " << tick;
  }
  EXPECT_NEAR(world.pose(footbot).position.x(), 4.5, 6e-3);
  EXPECT_NEAR(world.pose(footbot).position.y(), 5.0, 5e-3);
}

TEST(RoughGroundTest, AFootbotClimbsASlope) {
  for (const double degrees : {5.0, 10.0, 20.0}) {
    World world;
    const double rise = std::tan(degrees * kDegree);
    world.setTerrain(terrainOf([&](double x, double) { return rise * std::max(0.0, x - 4.5); }, 0.05));
    const Row footbot = world.addFootbot(flatPose(4.2, 5.0));
    world.drive(footbot, 0.1);
    world.step(100);
    const Vector3d on_ramp = world.pose(footbot).position - Vector3d(4.5, 5.0, 0.0);
    EXPECT_NEAR(on_ramp.norm(), 0.7, 0.03) << degrees;
    EXPECT_NEAR(on_ramp.z(), on_ramp.x() * rise, 1e-3) << degrees;
    EXPECT_NEAR(pitchOf(world.pose(footbot)), degrees * kDegree, 1.0 * kDegree) << degrees;
    EXPECT_NEAR(headingOf(world.pose(footbot)), 0.0, 1.0 * kDegree) << degrees;
    world.drive(footbot, 0.0);
    world.step(5);
    const Vector3d stopped = world.pose(footbot).position;
    world.step(20);
    EXPECT_LT((world.pose(footbot).position - stopped).norm(), 2e-4) << degrees;
  }
}

TEST(RoughGroundTest, BeyondTheFrictionAngleTreelsSlip) {
  World world({{"treel_friction", "0.3"}});
  const double angle = 20.0 * kDegree;
  const double rise = std::tan(angle);
  world.setTerrain(terrainOf([&](double x, double) { return rise * (x - 4.0); }, 0.05));
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(-angle, Vector3d::UnitY()));
  const Row footbot = world.addFootbot({{5.0, 5.0, rise}, tilt});
  world.step(5);
  const double expected = 0.5 * kGravity * (std::sin(angle) - 0.3 * std::cos(angle)) * 0.25;
  EXPECT_NEAR((tilt.conjugate() * (world.pose(footbot).position - Vector3d(5.0, 5.0, rise))).x(), -expected,
              0.1 * expected);
}

TEST(RoughGroundTest, AFootbotFallsIntoAHoleAndStaysInIt) {
  World world;
  // 0.4 m deep, with walls one cell wide
  world.setTerrain(terrainOf(
      [](double x, double y) { return std::max(std::abs(x - 5.0), std::abs(y - 5.0)) < 0.35 ? -0.4 : 0.0; }, 0.05));
  const Row footbot = world.addFootbot(flatPose(4.3, 5.0));
  world.drive(footbot, 0.2);
  double deepest = 0.0;
  for (int tick = 0; tick < 400; ++tick) {
    world.drive(footbot, 0.2, tick < 100 ? 0.0 : 2.0 * std::sin(0.05 * tick));
    world.step();
    deepest = std::min(deepest, world.pose(footbot).position.z());
    ASSERT_GT(world.pose(footbot).position.z(), -0.42) << "tick " << tick;
    if (tick > 60) {
      ASSERT_LT(world.pose(footbot).position.z(), -0.1) << "tick " << tick;
    }
  }
  EXPECT_LT(deepest, -0.2);  // it may lie on its back, with the origin on top
}

TEST(RoughGroundTest, ATerrainWhollyBelowTheLevelGroundIsAHoleWithWalls) {
  World world;
  world.setTerrain(terrainOf([](double, double) { return -0.3; }, 0.1, 0.5));
  const Row footbot = world.addFootbot(flatPose(5.0, 5.0, 0.4, -0.3));
  const Row prey = world.add(cylindricPreyModel(0.06, 0.1, 0.3), flatPose(5.3, 5.0, 0.0, -0.3));
  world.drive(footbot, 0.2);
  for (int tick = 0; tick < 200; ++tick) {
    world.step();
    for (const Row row : {footbot, prey}) {
      const Vector3d& position = world.pose(row).position;
      ASSERT_LT(std::max(std::abs(position.x() - 5.0), std::abs(position.y() - 5.0)), 0.5) << "tick " << tick;
      ASSERT_GT(position.z(), -0.31) << "tick " << tick;
      ASSERT_LT(position.z(), -0.1) << "tick " << tick;
    }
  }
}

TEST(RoughGroundTest, ACliffStopsAFootbot) {
  World world;
  world.setTerrain(terrainOf([](double, double) { return 0.3; }, 0.1));
  const Row footbot = world.addFootbot(flatPose(3.5, 5.0));
  world.drive(footbot, 0.2);
  world.step(60);
  const Vector3d& position = world.pose(footbot).position;
  EXPECT_NEAR(position.x(), 4.0 - 0.11, 3e-3);  // the gripper's box is in front
  EXPECT_LT(std::abs(position.z()), 0.02);
}

TEST(RoughGroundTest, WhatStandsOnASlopeStays) {
  World world;
  const double angle = 10.0 * kDegree;
  world.setTerrain(terrainOf([&](double x, double) { return std::tan(angle) * (x - 4.0); }, 0.05));
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(-angle, Vector3d::UnitY()));
  const auto on_slope = [&](double x, double y, double height) -> Pose {
    return {Vector3d(x, y, std::tan(angle) * (x - 4.0)) + tilt * Vector3d(0.0, 0.0, height), tilt};
  };
  const std::vector<Row> rows = {world.add(cylindricPreyModel(0.06, 0.1, 0.3), on_slope(4.5, 5.0, 0.0)),
                                 world.addBlock({0.3, 0.2, 0.1}, 1.0, on_slope(5.0, 5.4, 0.05)),
                                 world.addFootbot(on_slope(5.4, 4.6, 0.0))};
  std::vector<Pose> before;
  for (const Row row : rows) {
    before.push_back(world.pose(row));
  }
  world.step(50);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_LT((world.pose(rows[i]).position - before[i].position).norm(), 1e-3) << "entity " << i;
    EXPECT_LT(world.pose(rows[i]).orientation.angularDistance(before[i].orientation), 0.01) << "entity " << i;
    EXPECT_LT(world.twist(rows[i]).linear.norm(), 1e-3) << "entity " << i;
  }
}

TEST(RoughGroundTest, AnEyebotLandsOnAHill) {
  World world;
  world.setTerrain(terrainOf(
      [](double x, double y) { return 0.3 * std::exp(-4.0 * (std::pow(x - 5.0, 2) + std::pow(y - 5.0, 2))); }, 0.05));
  const Row eyebot = world.addEyebot(flatPose(5.0, 5.0, 0.0, 0.8));
  world.flight(eyebot).linear.z() = -0.2;
  world.step(60);
  const double lowest = world.space.entities.model[eyebot]->lowest;
  EXPECT_NEAR(world.pose(eyebot).position.z() + lowest, 0.3, 0.01);
}

TEST(RoughGroundTest, RefusesWhatStandsInTheGround) {
  World world;
  world.setTerrain(terrainOf([](double x, double) { return 0.2 * (x - 4.0); }, 0.05));
  const auto prey = cylindricPreyModel(0.1, 0.1);
  EXPECT_EQ(world.engine.invalidPoseReason(*prey, flatPose(5.0, 5.0, 0.0, 0.2)),
            "found at z = 0.2, where it stands in the terrain, allowed: above it, here from z = 0.22");
  EXPECT_EQ(world.engine.invalidPoseReason(*prey, flatPose(5.0, 5.0, 0.0, 0.2201)), "");
  EXPECT_EQ(world.engine.invalidPoseReason(*prey, flatPose(5.0, 5.0, 0.0, 1.0)), "");
  EXPECT_NE(world.engine.invalidPoseReason(*prey, flatPose(6.05, 5.0, 0.0, 0.1)), "");  // half in a cliff
  EXPECT_EQ(world.engine.invalidPoseReason(*prey, flatPose(6.5, 5.0, 0.0, 0.0)), "");   // outside
  EXPECT_EQ(world.engine.invalidPoseReason(*prey, flatPose(6.5, 5.0, 0.0, -0.1)),
            "found at z = -0.1, where it reaches down to z = -0.1, allowed: above the ground, which is at z = 0");
}

TEST(RoughGroundTest, WhatItHasCarriedItDoesNotRefuse) {
  World world;
  world.setTerrain(terrainOf([](double x, double y) { return 0.03 * std::sin(12.0 * x) * std::cos(9.0 * y); }, 0.05));
  const Row footbot = world.addFootbot(flatPose(4.4, 5.0, 0.0, 0.05));
  world.drive(footbot, 0.1);
  world.step(3);  // after a fall, its soft balls are compressed for some 70 ms
  for (int tick = 0; tick < 100; ++tick) {
    world.step();
    ASSERT_EQ(world.engine.invalidPoseReason(*robotModel("footbot"), world.pose(footbot)), "") << "tick " << tick;
  }
}

/// Eight footbots and four preys on hills, within walls.
struct RoughCrowd {
  explicit RoughCrowd(World::Values values = {}) : world(values) {
    terrain = terrainOf(
        [](double x, double y) {
          return 0.08 * std::sin(7.0 * x) * std::cos(6.0 * y) + 0.02 * std::sin(23.0 * x + 17.0 * y) - 0.02;
        },
        0.05);
    world.setTerrain(terrain);
    for (const double side : {-1.05, 1.05}) {
      world.addBlock({0.1, 2.2, 1.0}, 0.0, flatPose(5.0 + side, 5.0));
      world.addBlock({2.0, 0.1, 1.0}, 0.0, flatPose(5.0, 5.0 + side));
    }
    for (int i = 0; i < 12; ++i) {
      const Pose pose = flatPose(4.4 + 0.4 * (i % 4), 4.5 + 0.5 * (i / 4), 0.9 * i, 0.16);
      if (i % 3 == 2) {
        preys.push_back(world.add(cylindricPreyModel(0.06, 0.1, 0.3), pose));
      } else {
        footbots.push_back(world.addFootbot(pose));
      }
    }
  }

  void step(int tick) {
    for (std::size_t i = 0; i < footbots.size(); ++i) {
      const auto k = static_cast<double>(i);
      world.drive(footbots[i], 0.25 * std::sin(0.9 * k + 0.05 * tick), 2.0 * std::cos(1.3 * k + 0.07 * tick));
      world.setGripper(footbots[i], (static_cast<int>(i) + tick / 20) % 3 == 0);
    }
    world.step();
  }

  void expectSane(int tick) const {
    for (const auto* rows : {&footbots, &preys}) {
      for (const Row row : *rows) {
        const Twist& twist = world.twist(row);
        const Vector3d& position = world.pose(row).position;
        ASSERT_TRUE(position.allFinite() && twist.linear.allFinite() && twist.angular.allFinite());
        ASSERT_LT(twist.linear.norm(), 2.5) << "entity " << toIndex(row) << ", tick " << tick;
        ASSERT_LT(twist.angular.norm(), 40.0) << "entity " << toIndex(row) << ", tick " << tick;
        // the origin is at the bottom: in or on the surface, or above it if the body lies on its side
        ASSERT_GT(position.z(), terrain->heightAt(position.x(), position.y()) - 0.02)
            << "entity " << toIndex(row) << ", tick " << tick;
        ASSERT_LT(position.z(), 0.5) << "entity " << toIndex(row) << ", tick " << tick;
      }
    }
  }

  World world;
  std::shared_ptr<const Terrain> terrain;
  std::vector<Row> footbots;
  std::vector<Row> preys;
};

TEST(RoughCrowdTest, NobodyFallsThroughInALongRun) {
  RoughCrowd crowd;
  for (int tick = 0; tick < 2000; ++tick) {
    crowd.step(tick);
    ASSERT_NO_FATAL_FAILURE(crowd.expectSane(tick));
  }
}

TEST(RoughCrowdTest, TheSameRunGivesTheSameBits) {
  const auto hashes = [] {
    RoughCrowd crowd;
    std::vector<std::uint64_t> result;
    for (int tick = 0; tick < 80; ++tick) {
      crowd.step(tick);
      result.push_back(stateHash(crowd.world.space));
    }
    return result;
  };
  EXPECT_EQ(hashes(), hashes());
}

TEST(RoughCrowdTest, ASteadyTickAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  RoughCrowd crowd;
  for (const Row row : crowd.footbots) {
    crowd.world.setGripper(row, false);
  }
  for (int tick = 0; tick < 300; ++tick) {
    crowd.world.step();
  }
  const long before = heap_allocations;
  for (int tick = 0; tick < 50; ++tick) {
    crowd.world.step();
    crowd.world.castRay({4.0, 4.0, 0.3}, {6.0, 6.0, -0.2});
  }
  EXPECT_EQ(heap_allocations - before, 0);
  EXPECT_GT(before, 100);
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
