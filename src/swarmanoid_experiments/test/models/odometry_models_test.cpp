// The formula of docs/reference/models.md, "Sensing": odometry; and encoders and odometry in motions simulated by
// engines.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "model_world.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/odometry.hpp"
#include "swarmanoid_interface/devices/wheel_encoders.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kTick = 0.1;  // s

ModelWorld drivingWorld(const std::string& engine, double x = 5.0, double y = 5.0, double heading = 71.0) {
  ModelWorld world;
  world.engine = engine;
  world.wheels = "<differential_drive/>";
  world.footbot_sensors = "<odometry/><wheel_encoders/>";
  world.entities = robot("footbot", "fb", x, y, 0.0, heading);
  world.members = "fb";
  return world;
}

/// True pose of the robot relative to its start pose.
struct Truth {
  Eigen::Vector2d position;
  double heading;
};

Truth truthFrom(const Simulation& simulation, const Eigen::Vector2d& start, double start_heading) {
  const Eigen::Vector2d way = poseOf(simulation, "fb").position.head<2>() - start;
  const Eigen::Rotation2Dd back(-start_heading);
  return {back * way, std::remainder(headingOf(simulation, "fb") - start_heading, 2.0 * M_PI)};
}

/// A program that drives and records readings.
struct Driver {
  double speed = 0.0;
  double turn_rate = 0.0;
  Odometry odometry;
  WheelEncoders encoders;

  void attach() {
    setProgram([this](Robot& robot) {
      odometry = robot.sensor<Odometry>();
      encoders = robot.sensor<WheelEncoders>();
      robot.actuator<DifferentialDrive>().drive(speed, turn_rate);
    });
  }
  /// Drives for some ticks. The readings are those at their end.
  void drive(Simulation& simulation, double v, double omega, int ticks) {
    speed = v;
    turn_rate = omega;
    tick(simulation, ticks);
    speed = turn_rate = 0.0;
    tick(simulation);
  }
};

TEST(ModelsPageTest, OdometryPoseAndCovariance) {
  const std::vector<std::array<double, 3>> legs{{0.173, 0.611, 23}, {-0.094, 1.37, 17}, {0.21, 0.0, 9}};
  ModelWorld world = drivingWorld("kinematics2d");
  world.footbot_sensors = "<odometry><assumed_slip>0.017</assumed_slip></odometry><wheel_encoders/>";
  Driver driver;
  driver.attach();
  auto simulation = world.start();
  double x = 0.0;
  double y = 0.0;
  double heading = 0.0;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double left_turned = 0.0;
  double right_turned = 0.0;
  for (const auto& [v, omega, ticks] : legs) {
    driver.drive(*simulation, v, omega, static_cast<int>(ticks));
    // pose: the arc as a whole
    const double time = ticks * kTick;
    const double x_before = x;
    const double y_before = y;
    const double heading_before = heading;
    heading += omega * time;
    x += omega == 0.0 ? v * time * std::cos(heading) : v / omega * (std::sin(heading) - std::sin(heading_before));
    y += omega == 0.0 ? v * time * std::sin(heading) : -v / omega * (std::cos(heading) - std::cos(heading_before));
    // covariance: tick by tick, with derivatives as finite differences of the arc
    double tick_x = x_before;
    double tick_y = y_before;
    double tick_heading = heading_before;
    const auto step = [](const Eigen::Vector3d& pose, double left, double right) -> Eigen::Vector3d {
      const double turn = (right - left) / kSeparation;
      const double way = 0.5 * (left + right) * (turn == 0.0 ? 1.0 : std::sin(turn / 2.0) / (turn / 2.0));
      return {pose.x() + way * std::cos(pose.z() + turn / 2.0), pose.y() + way * std::sin(pose.z() + turn / 2.0),
              pose.z() + turn};
    };
    const double left = (v - omega * kSeparation / 2.0) * kTick;
    const double right = (v + omega * kSeparation / 2.0) * kTick;
    for (int k = 0; k < static_cast<int>(ticks); ++k) {
      const Eigen::Vector3d pose(tick_x, tick_y, tick_heading);
      constexpr double kSmall = 1e-6;
      Eigen::Matrix3d by_pose;
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d d = kSmall * Eigen::Vector3d::Unit(i);
        by_pose.col(i) = (step(pose + d, left, right) - step(pose - d, left, right)) / (2.0 * kSmall);
      }
      const Eigen::Vector3d by_left =
          (step(pose, left + kSmall, right) - step(pose, left - kSmall, right)) / (2.0 * kSmall);
      const Eigen::Vector3d by_right =
          (step(pose, left, right + kSmall) - step(pose, left, right - kSmall)) / (2.0 * kSmall);
      covariance = by_pose * covariance * by_pose.transpose() + 0.017 * 0.017 *
                                                                    (std::abs(left) * by_left * by_left.transpose() +
                                                                     std::abs(right) * by_right * by_right.transpose());
      const Eigen::Vector3d next = step(pose, left, right);
      tick_x = next.x();
      tick_y = next.y();
      tick_heading = next.z();
    }
    left_turned += (v - omega * kSeparation / 2.0) * time / kWheelRadius;
    right_turned += (v + omega * kSeparation / 2.0) * time / kWheelRadius;
    EXPECT_NEAR(driver.odometry.x, x, 1e-9);
    EXPECT_NEAR(driver.odometry.y, y, 1e-9);
    EXPECT_NEAR(std::remainder(driver.odometry.heading - heading, 2.0 * M_PI), 0.0, 1e-9);
    EXPECT_NEAR(driver.encoders.left.turned, left_turned, 1e-9);
    EXPECT_NEAR(driver.encoders.right.turned, right_turned, 1e-9);
    for (int i = 0; i < 9; ++i) {
      // to first order in the turn per tick
      EXPECT_NEAR(driver.odometry.covariance[static_cast<std::size_t>(i)], covariance(i / 3, i % 3),
                  2e-3 * covariance.norm())
          << "entry " << i;
    }
    EXPECT_GT(covariance.trace(), 1e-6);
  }
}

/// Without slip odometry agrees with the truth: up to rounding if wheels set velocities, else as well as treels hold.
TEST(OdometryEngineTest, AgreesWithTheTruthWhereNothingSlips) {
  const struct Case {
    const char* engine;
    double allowed_way;      // m, of 1.4 m
    double allowed_heading;  // rad, of 3.2 rad
  } cases[] = {{"kinematics2d", 1e-9, 1e-9}, {"dynamics2d", 0.02, 0.03}, {"dynamics3d", 0.02, 0.03}};
  for (const Case& expected : cases) {
    ModelWorld world = drivingWorld(expected.engine);
    world.engine_parameters = "<subclock>20</subclock>";
    Driver driver;
    driver.attach();
    auto simulation = world.start();
    driver.drive(*simulation, 0.137, 0.43, 61);
    driver.drive(*simulation, -0.081, 0.43, 13);
    driver.drive(*simulation, 0.19, 0.0, 22);
    driver.drive(*simulation, 0.0, 0.0, 10);  // until the robot is at rest
    const Truth truth = truthFrom(*simulation, {5.0, 5.0}, 71.0 * kDegree);
    EXPECT_GT(truth.position.norm(), 0.2) << expected.engine;
    EXPECT_NEAR(driver.odometry.x, truth.position.x(), expected.allowed_way) << expected.engine;
    EXPECT_NEAR(driver.odometry.y, truth.position.y(), expected.allowed_way) << expected.engine;
    EXPECT_NEAR(std::remainder(driver.odometry.heading - truth.heading, 2.0 * M_PI), 0.0, expected.allowed_heading)
        << expected.engine;
    EXPECT_EQ(driver.encoders.left.step, 0.0) << expected.engine;
  }
}

/// A wall blocks the robot; its wheels turn on, and odometry follows them.
TEST(OdometryEngineTest, WheelsOfABlockedRobotTurnOn) {
  for (const char* engine : {"kinematics2d", "dynamics2d", "dynamics3d"}) {
    ModelWorld world = drivingWorld(engine, 5.0, 5.0, 0.0);
    world.engine_parameters = "<subclock>10</subclock>";
    world.entities += block("wall", 5.25, 5.0, 0.25, "0.1, 2, 0.5");
    world.members += " wall";
    Driver driver;
    driver.attach();
    auto simulation = world.start();
    driver.drive(*simulation, 0.1, 0.0, 40);
    driver.drive(*simulation, 0.0, 0.0, 10);
    EXPECT_LT(poseOf(*simulation, "fb").position.x(), 5.12) << engine << ": the wall stands 0.2 m ahead";
    EXPECT_NEAR(driver.odometry.x, 0.4, 0.01) << engine;
    EXPECT_NEAR(driver.encoders.right.turned, 0.4 / kWheelRadius, 0.01 / kWheelRadius) << engine;
  }
}

TEST(OdometryEngineTest, DoesNotNoticeThatTheRobotIsCarriedAway) {
  for (const char* engine : {"kinematics2d", "dynamics3d"}) {
    ModelWorld world = drivingWorld(engine);
    Driver driver;
    driver.attach();
    auto simulation = world.start();
    driver.drive(*simulation, 0.11, 0.0, 10);
    driver.drive(*simulation, 0.0, 0.0, 5);
    const Odometry before = driver.odometry;
    const WheelEncoders turned = driver.encoders;
    simulation->apply(
        MoveEntity{"fb", {{8.0, 6.0, 0.0}, Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()))}});
    driver.drive(*simulation, 0.0, 0.0, 3);
    EXPECT_EQ(driver.odometry.x, before.x) << engine;
    EXPECT_EQ(driver.odometry.y, before.y) << engine;
    EXPECT_EQ(driver.odometry.heading, before.heading) << engine;
    EXPECT_EQ(driver.encoders.left.turned, turned.left.turned) << engine;
    driver.drive(*simulation, 0.11, 0.0, 10);
    driver.drive(*simulation, 0.0, 0.0, 5);
    EXPECT_NEAR(driver.odometry.x - before.x, 0.11, 0.005) << engine << ": it goes on as if it were where it was";
  }
}

TEST(OdometryEngineTest, BeginsAnewAtAReset) {
  ModelWorld world = drivingWorld("kinematics2d");
  Driver driver;
  driver.attach();
  auto simulation = world.start();
  driver.drive(*simulation, 0.11, 0.3, 10);
  EXPECT_GT(driver.odometry.x, 0.09);
  EXPECT_GT(driver.encoders.right.turned, 3.0);
  simulation->reset();
  driver.drive(*simulation, 0.0, 0.0, 1);
  EXPECT_EQ(driver.odometry.x, 0.0);
  EXPECT_EQ(driver.odometry.heading, 0.0);
  EXPECT_EQ(driver.odometry.covariance[0], 0.0);
  EXPECT_EQ(driver.encoders.right.turned, 0.0);
}

}  // namespace
}  // namespace swarmanoid::test
