// Devices on rough ground.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"

namespace swarmanoid::test {
namespace {

using Eigen::Vector3d;

/// Returns a terrain from (4, 4) to (6, 6), with a vertex every 0.1 m.
std::shared_ptr<const Terrain> terrainOf(const std::function<double(double x)>& height) {
  std::vector<double> heights;
  for (int j = 0; j <= 20; ++j) {
    for (int i = 0; i <= 20; ++i) {
      heights.push_back(height(4.0 + 0.1 * i));
    }
  }
  return std::make_shared<const Terrain>(Eigen::Vector2d(4.0, 4.0), Eigen::Vector2d(2.0, 2.0), 21, 21, heights);
}

/// A ridge along y at x = 5, half a metre high.
double ridge(double x) { return std::max(0.0, 0.5 - std::abs(x - 5.0)); }

TEST(TerrainTest, AHillHidesAPreyFromTheCameraOfAFootbot) {
  DeviceWorld world;
  world.space.terrain = terrainOf(&ridge);
  SensorUnderTest<FootbotCamera> camera(world, world.addFootbot(4.3, 5.0));
  const Row prey = world.addPrey(5.7, 5.0);
  EXPECT_TRUE(camera.sense().blobs.empty());
  world.pose(prey).position = {5.0, 5.0, 0.5};  // on the ridge
  ASSERT_EQ(camera.sense().blobs.size(), 1U);
  EXPECT_NEAR(camera.sense().blobs[0].distance, 0.7, 1e-6);
}

TEST(TerrainTest, WhatLiesInAHoleIsSeenFromAbove) {
  DeviceWorld world;
  world.space.terrain = terrainOf([](double) { return -1.0; });
  const Row prey = world.addPrey(5.5, 5.0);
  world.pose(prey).position.z() = -1.0;
  SensorUnderTest<EyebotCamera> above(world, world.addEyebot(5.0, 5.0, 1.0));
  EXPECT_EQ(above.sense().blobs.size(), 1U);
  SensorUnderTest<EyebotCamera> aside(world, world.addEyebot(7.0, 5.0, 1.0));
  EXPECT_TRUE(aside.sense().blobs.empty());  // the ground around the hole hides the prey
}

TEST(TerrainTest, AProximitySensorReadsASlope) {
  DeviceWorld world;
  world.space.terrain = terrainOf([](double x) { return std::max(0.0, x - 5.0); });
  const Row robot = world.addFootbot(4.9, 5.0);
  SensorUnderTest<FootbotProximity> proximity(world, robot);
  // the ring is 0.06 m high and has a radius of 0.085 m, so the slope is 0.075 m ahead of it
  const auto& values = proximity.sense().value;
  EXPECT_NEAR(values[0], std::pow(0.25, 3), 1e-6);
  EXPECT_EQ(values[12], 0.0F);  // behind
  world.pose(robot).position.x() = 4.5;
  const auto& far_away = proximity.sense().value;
  EXPECT_EQ(*std::max_element(far_away.begin(), far_away.end()), 0.0F);
}

TEST(TerrainTest, ALaserSpotLiesOnTheGroundHoweverHighItIs) {
  for (const double height : {0.3, 0.0, -0.7}) {
    DeviceWorld world;
    world.space.terrain = terrainOf([height](double) { return height; });
    const Row robot = world.addEyebot(5.0, 5.0, 2.0);
    ActuatorUnderTest<EyebotLaser> laser(world, robot);
    laser.command.on = true;
    laser.actuate();
    laser.actuator->afterMove(world.space, AfterMoveAccess(world.space));
    ASSERT_EQ(world.space.laser_spots.size(), 1U);
    EXPECT_LT((world.space.laser_spots[0].position - Vector3d(5.05, 5.0, height)).norm(), 1e-9);
    // the camera sees the spot there, too
    SensorUnderTest<FootbotCamera> camera(world, world.add(robotModel("footbot"), {4.5, 5.0, height}));
    EXPECT_EQ(camera.sense().blobs.size(), 1U) << height;
  }
}

TEST(TerrainTest, ALaserBesideAHoleEndsOnTheFloor) {
  DeviceWorld world;
  world.space.terrain = terrainOf([](double) { return -0.7; });
  const Row robot = world.addEyebot(7.0, 5.0, 2.0);
  ActuatorUnderTest<EyebotLaser> laser(world, robot);
  laser.command.on = true;
  laser.actuate();
  laser.actuator->afterMove(world.space, AfterMoveAccess(world.space));
  EXPECT_NEAR(world.space.laser_spots.at(0).position.z(), 0.0, 1e-9);
}

}  // namespace
}  // namespace swarmanoid::test
