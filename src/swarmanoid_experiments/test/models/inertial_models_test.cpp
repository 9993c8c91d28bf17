// The formula of docs/reference/models.md, "Sensing": the inertial unit; and that unit in motions simulated by engines.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/imu.hpp"

namespace swarmanoid::test {
namespace {

TEST(ModelsPageTest, InertialReading) {
  const struct Drive {
    double v;
    double omega;
  } drives[] = {{0.1, 0.0}, {0.1, 0.0}, {0.17, 0.9}, {0.17, 0.9}, {-0.05, -1.7}, {0.0, 0.0}, {0.0, 0.0}};
  constexpr double kTick = 0.1;  // s
  ModelWorld world;
  world.wheels = "<differential_drive/>";
  world.footbot_sensors = "<imu/>";
  world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 71.0);
  world.members = "fb";
  std::vector<Imu> readings;
  setProgram([&](Robot& robot) {
    const Drive& drive = drives[readings.size()];
    readings.push_back(robot.sensor<Imu>());
    robot.actuator<DifferentialDrive>().drive(drive.v, drive.omega);
  });
  auto simulation = world.start();
  tick(*simulation, static_cast<int>(std::size(drives)));
  ASSERT_EQ(readings.size(), std::size(drives));
  EXPECT_EQ(readings[0].linear_acceleration, Eigen::Vector3d(0.0, 0.0, 9.81)) << "before it has moved";
  for (std::size_t k = 1; k < readings.size(); ++k) {
    const Drive before = k == 1 ? Drive{0.0, 0.0} : drives[k - 2];
    const Drive& now = drives[k - 1];
    // at the ends of both ticks it moves straight ahead in its own frame
    const double turning = (now.omega + before.omega) / 2.0;
    const Eigen::Vector3d expected((now.v - before.v) / kTick, turning * (now.v + before.v) / 2.0, 9.81);
    EXPECT_NEAR((readings[k].linear_acceleration - expected).norm(), 0.0, 1e-9) << "tick " << k;
    EXPECT_NEAR((readings[k].angular_velocity - Eigen::Vector3d(0.0, 0.0, now.omega)).norm(), 0.0, 1e-9) << k;
  }
}

/// In engines with forces the velocity is that at the end of the tick, within half a step: on an arc the acceleration v
/// omega points to the centre, which is to the left in a left turn.
TEST(InertialEngineTest, AnArcIsFeltTowardsItsCentre) {
  constexpr double kSpeed = 0.17;  // m/s
  for (const char* engine : {"dynamics2d", "dynamics3d"}) {
    for (const double omega : {0.9, -0.9}) {
      ModelWorld world;
      world.engine = engine;
      world.engine_parameters = "<subclock>20</subclock>";
      world.wheels = "<differential_drive/>";
      world.footbot_sensors = "<imu/>";
      world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 71.0);
      world.members = "fb";
      constexpr int kStarting = 20;  // ticks until it has reached its speed
      constexpr int kSteady = 20;
      int ticks = 0;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      double turning = 0.0;
      setProgram([&](Robot& robot) {
        robot.actuator<DifferentialDrive>().drive(kSpeed, omega);
        if (ticks++ >= kStarting) {
          sum += robot.sensor<Imu>().linear_acceleration;
          turning += robot.sensor<Imu>().angular_velocity.z();
        }
      });
      auto simulation = world.start();
      tick(*simulation, kStarting + kSteady);
      const Eigen::Vector3d mean = sum / kSteady;  // averages out the shaking by contacts
      const std::string where = join(engine, ", turn rate ", omega);
      constexpr double kAllowed = 0.05 * 0.9 * kSpeed;
      EXPECT_NEAR(turning / kSteady, omega, 0.02 * 0.9) << where;
      EXPECT_NEAR(mean.x(), 0.0, kAllowed) << where;
      EXPECT_NEAR(mean.y(), omega * kSpeed, kAllowed) << where;
      EXPECT_NEAR(mean.z(), 9.81, 0.01) << where;
    }
  }
}

/// A robot on an arc measures v omega towards its centre, and no difference when another engine takes it over. The
/// velocity of dynamics2d is that at the end of a tick within half a step, v omega / (2 * 20) here.
TEST(InertialEngineTest, AHandoverOnAnArcIsNotFelt) {
  constexpr double kSpeed = 0.137;  // m/s
  for (const double omega : {0.58, -0.58}) {
    ModelWorld world;
    world.more_engines = "<dynamics2d id='flat'><subclock>20</subclock></dynamics2d>";
    world.wheels = "<differential_drive/>";
    world.footbot_sensors = "<imu/>";
    world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 71.0);
    world.members = "fb";
    std::vector<Imu> readings;
    setProgram([&](Robot& robot) {
      robot.actuator<DifferentialDrive>().drive(kSpeed, omega);
      readings.push_back(robot.sensor<Imu>());
    });
    auto simulation = world.start();
    tick(*simulation, 12);
    for (const char* engine : {"flat", "engine", "flat", "engine"}) {
      simulation->apply(HandOverEntity{"fb", engine});
      tick(*simulation, 7);
    }
    constexpr std::size_t kStarting = 3;
    for (std::size_t k = kStarting; k < readings.size(); ++k) {
      const Eigen::Vector3d expected(0.0, omega * kSpeed, 9.81);
      EXPECT_NEAR((readings[k].linear_acceleration - expected).norm(), 0.0, 1.2 * 0.58 * kSpeed / 40.0)
          << "tick " << k << ": " << readings[k].linear_acceleration.transpose();
      EXPECT_NEAR(readings[k].angular_velocity.z(), omega, 1e-5) << "tick " << k;
    }
  }
}

/// At rest the unit measures the gravity of the robot's engine; in kinematics2d, which has none, that of the Earth.
TEST(InertialEngineTest, GravityIsThatOfTheEngine) {
  for (const char* engine : {"kinematics2d", "dynamics2d", "dynamics3d"}) {
    ModelWorld world;
    world.engine = engine;
    const bool has_gravity = world.engine != "kinematics2d";
    world.engine_parameters = has_gravity ? "<gravity>3.71</gravity>" : "";
    world.footbot_sensors = "<imu/>";
    world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 71.0);
    world.members = "fb";
    Imu imu;
    setProgram([&](Robot& robot) { imu = robot.sensor<Imu>(); });
    auto simulation = world.start();
    tick(*simulation, 30);
    EXPECT_NEAR(imu.linear_acceleration.z(), has_gravity ? 3.71 : 9.81, 0.02) << engine;
  }
}

/// In free fall the unit measures zero, also in the tick after a change of gravity.
TEST(InertialEngineTest, GravityThatChangesInFreeFallIsNotFelt) {
  ModelWorld world;
  world.engine = "dynamics3d";
  world.engine_parameters = "<gravity>1.62</gravity>";
  world.footbot_sensors = "<imu/>";
  world.entities = robot("footbot", "fb", 5.0, 5.0, 6.0, 71.0);
  world.members = "fb";
  std::vector<double> readings;
  setProgram([&](Robot& robot) { readings.push_back(robot.sensor<Imu>().linear_acceleration.norm()); });
  auto simulation = world.start();
  tick(*simulation, 3);
  simulation->apply(SetEngineParameters{"engine", {{"gravity", "3.71"}}});
  tick(*simulation, 4);
  ASSERT_EQ(readings.size(), 7U);
  EXPECT_NEAR(readings[0], 1.62, 1e-9) << "before it falls nothing is known of its motion";
  for (std::size_t k = 1; k < readings.size(); ++k) {
    EXPECT_NEAR(readings[k], 0.0, 1e-9) << "tick " << k;
  }
}

/// Each of the three robot types may have the unit, in each engine: at rest it measures the supporting acceleration
/// (REP-145).
TEST(InertialEngineTest, AtRestEachRobotFeelsGravityUpwards) {
  for (const char* engine : {"kinematics2d", "dynamics2d", "dynamics3d"}) {
    for (const char* type : {"footbot", "eyebot", "handbot"}) {
      ModelWorld world;
      world.engine = engine;
      world.footbot_sensors = world.eyebot_sensors = world.handbot_sensors = "<imu/>";
      world.footbot_actuators = world.handbot_actuators = "";
      world.entities = robot(type, "it", 5.0, 5.0, 0.0, 71.0);
      world.members = "it";
      Imu imu;
      setProgram([&](Robot& robot) { imu = robot.sensor<Imu>(); });
      auto simulation = world.start();
      tick(*simulation, 30);
      const std::string where = join(type, " in ", engine);
      EXPECT_NEAR((imu.linear_acceleration - Eigen::Vector3d(0.0, 0.0, 9.81)).norm(), 0.0, 0.05) << where;
      EXPECT_NEAR(imu.angular_velocity.norm(), 0.0, 0.01) << where;
    }
  }
}

/// Moving a robot from outside stops it. The unit measures only its new start, 3 m/s2 in a tick.
TEST(InertialEngineTest, BeingMovedFromOutsideIsNotFelt) {
  ModelWorld world;
  world.wheels = "<differential_drive/>";
  world.footbot_sensors = "<imu/>";
  world.entities = robot("footbot", "fb", 5.0, 5.0, 0.0, 71.0);
  world.members = "fb";
  std::vector<Eigen::Vector3d> readings;
  setProgram([&](Robot& robot) {
    readings.push_back(robot.sensor<Imu>().linear_acceleration);
    robot.actuator<DifferentialDrive>().drive(0.3, 0.0);
  });
  auto simulation = world.start();
  tick(*simulation, 3);
  simulation->apply(
      MoveEntity{"fb", {{8.0, 6.0, 0.0}, Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()))}});
  tick(*simulation, 3);
  const double expected[] = {0.0, 3.0, 0.0, 0.0, 3.0, 0.0};  // ahead, m/s2
  ASSERT_EQ(readings.size(), std::size(expected));
  for (std::size_t k = 0; k < readings.size(); ++k) {
    EXPECT_NEAR((readings[k] - Eigen::Vector3d(expected[k], 0.0, 9.81)).norm(), 0.0, 1e-9) << "tick " << k;
  }
}

}  // namespace
}  // namespace swarmanoid::test
