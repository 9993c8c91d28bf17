// Eyebots that fly to positions, and the readings of their altimeters and barometers, in engines.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/eyebot_altitude.hpp"
#include "swarmanoid_interface/devices/eyebot_position.hpp"
#include "swarmanoid_interface/devices/eyebot_pressure.hpp"
#include "swarmanoid_interface/devices/imu.hpp"

namespace swarmanoid::test {
namespace {

ModelWorld flyingWorld(const std::string& engine, double height) {
  ModelWorld world;
  world.engine = engine;
  world.engine_parameters =
      engine == "dynamics3d" ? "<subclock>10</subclock>" : join("<distance>", height, "</distance>");
  world.eyebot_actuators = "<eyebot_position/>";
  world.eyebot_sensors = "<eyebot_altitude/><eyebot_pressure/><imu/>";
  world.entities = robot("eyebot", "eb", 9.0, 9.0, height, 51.0);
  world.members = "eb";
  return world;
}

TEST(ModelsPageTest, AirPressure) {
  double difference = 0.0;
  setProgram([&](Robot& robot) { difference = robot.sensor<EyebotPressure>().difference; });
  auto simulation = flyingWorld("dynamics3d", 0.61).start();
  tick(*simulation);
  EXPECT_EQ(difference, 0.0);
  for (const double height : {1.37, 0.05, 2.9}) {
    simulation->apply(MoveEntity{"eb", {{9.0, 9.0, height}, poseOf(*simulation, "eb").orientation}});
    tick(*simulation);
    EXPECT_NEAR(difference, 101325.0 * (std::pow(1.0 - 0.0065 * (height - 0.61) / 288.15, 5.25588) - 1.0), 1e-4);
  }
}

TEST(PositionFlightTest, ReachesAPlaceInItsPlane) {
  for (const char* engine : {"kinematics2d", "dynamics2d", "dynamics3d"}) {
    setProgram([](Robot& robot) { robot.actuator<EyebotPosition>().goTo({1.3, -0.7, 0.0}, 2.1); });
    auto simulation = flyingWorld(engine, 1.5).start();
    tick(*simulation, 150);
    const Eigen::Vector3d expected =
        Eigen::Vector3d(9.0, 9.0, 1.5) +
        Eigen::AngleAxisd(51.0 * kDegree, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(1.3, -0.7, 0.0);
    const double allowed = std::string(engine) == "kinematics2d" ? 1e-3 : 0.06;  // dead reckoning
    EXPECT_NEAR((poseOf(*simulation, "eb").position - expected).norm(), 0.0, allowed) << engine;
    EXPECT_NEAR(std::remainder(headingOf(*simulation, "eb") - 51.0 * kDegree - 2.1, 2.0 * M_PI), 0.0, 0.03) << engine;
  }
}

TEST(PositionFlightTest, TakesOffAndLandsWithForces) {
  EyebotAltitude altitude;
  EyebotPressure pressure;
  Imu imu;
  bool lands = false;
  setProgram([&](Robot& robot) {
    altitude = robot.sensor<EyebotAltitude>();
    pressure = robot.sensor<EyebotPressure>();
    imu = robot.sensor<Imu>();
    if (lands) {
      robot.actuator<EyebotPosition>().land();
    } else {
      robot.actuator<EyebotPosition>().takeOff(1.4);
    }
  });
  auto simulation = flyingWorld("dynamics3d", 0.0).start();
  tick(*simulation, 120);
  EXPECT_NEAR(poseOf(*simulation, "eb").position.z(), 1.4, 0.05);
  EXPECT_NEAR(altitude.distance, poseOf(*simulation, "eb").position.z(), 0.01);
  EXPECT_NEAR(pressure.difference, -16.82, 0.6) << "12 Pa a metre";
  EXPECT_NEAR(imu.linear_acceleration.z(), 9.81, 0.1) << "it hovers";
  lands = true;
  tick(*simulation, 120);
  EXPECT_NEAR(poseOf(*simulation, "eb").position.z(), 0.0, 0.01);
  EXPECT_EQ(altitude.distance, -std::numeric_limits<float>::infinity()) << "too close, also where it has sunk in";
  EXPECT_NEAR(twistOf(*simulation, "eb").linear.norm(), 0.0, 0.01);
}

TEST(PositionFlightTest, TwoFlightControllersAreRefused) {
  ModelWorld world = flyingWorld("kinematics2d", 1.5);
  world.eyebot_actuators = "<eyebot_velocity/><eyebot_position/>";
  try {
    world.start();
    FAIL() << "started";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("device 'eyebot_position' cannot be simulated: another device drives the "
                        "robot already"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace swarmanoid::test
