// Devices that measure the motion of a mock robot, and the one that flies it to positions.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mock_bench.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/eyebot_altitude.hpp"
#include "swarmanoid_interface/devices/eyebot_position.hpp"
#include "swarmanoid_interface/devices/eyebot_pressure.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/odometry.hpp"
#include "swarmanoid_interface/devices/positioning.hpp"
#include "swarmanoid_interface/devices/wheel_encoders.hpp"

namespace swarmanoid::mock {
namespace {

TEST(MockWheelEncoders, TurnAsTheRobotMoves) {
  World world;
  world.wheels = {0.02, 0.05};
  Bench bench(std::vector<std::string>{"differential_drive", "wheel_encoders"}, world);
  bench.command<DifferentialDrive>().drive(0.06, 0.8);
  bench.advance(1.5);
  const WheelEncoders& encoders = bench.reading<WheelEncoders>();
  // 0.04 and 0.08 m/s over 0.02 m
  EXPECT_NEAR(3.0, encoders.left.turned, 1e-9);
  EXPECT_NEAR(6.0, encoders.right.turned, 1e-9);
  EXPECT_NEAR(2.0 * kStep, encoders.left.step, 1e-12);
  EXPECT_NEAR(4.0, encoders.right.speed, 1e-12);
  bench.robot->place({{1.0, 2.0, 0.0}, 0.4});
  EXPECT_NEAR(3.0, encoders.left.turned, 1e-9) << "carrying it away turns no wheel";
}

TEST(MockOdometry, AgreesWithWhereTheRobotIsUntilItIsCarriedAway) {
  Bench bench(std::vector<std::string>{"differential_drive", "odometry", "positioning"});
  bench.command<DifferentialDrive>().drive(0.173, -0.611);
  bench.advance(2.3);
  const Odometry& odometry = bench.reading<Odometry>();
  const Pose& pose = bench.robot->state().pose;
  const double radius = 0.173 / 0.611;
  EXPECT_NEAR(radius * std::sin(0.611 * 2.3), odometry.x, 1e-9);
  EXPECT_NEAR(-radius * (1.0 - std::cos(0.611 * 2.3)), odometry.y, 1e-9);
  EXPECT_NEAR(pose.position.x(), odometry.x, 1e-9);
  EXPECT_NEAR(pose.yaw, odometry.heading, 1e-9);
  const Positioning& positioning = bench.reading<Positioning>();
  EXPECT_EQ(pose.position, positioning.position);
  EXPECT_NEAR(pose.yaw, positioning.heading, 1e-9);
  EXPECT_NEAR(0.173, odometry.speed, 1e-9);
  EXPECT_NEAR(-0.611, odometry.turn_rate, 1e-9);
  const double x = odometry.x;
  bench.robot->place({{5.0, 5.0, 0.0}, 0.0});
  bench.command<DifferentialDrive>().drive(0.0, 0.0);
  bench.advance(kStep);
  EXPECT_EQ(x, odometry.x);
}

TEST(MockEyebotHeight, IsThatOfItsPose) {
  Bench bench("eyebot");
  bench.robot->place({{0.3, 0.2, 1.37}, 0.0});
  EXPECT_EQ(1.37F, bench.reading<EyebotAltitude>().distance);
  EXPECT_NEAR(-16.45693, bench.reading<EyebotPressure>().difference, 1e-4);
  bench.robot->place({{0.3, 0.2, 0.0}, 0.0});
  EXPECT_EQ(-std::numeric_limits<float>::infinity(), bench.reading<EyebotAltitude>().distance);
  EXPECT_EQ(0.0, bench.reading<EyebotPressure>().difference);
}

TEST(MockEyebotPosition, FliesToAPlaceOfItsStart) {
  Bench bench("eyebot");
  bench.robot->place({{1.0, 2.0, 0.5}, 0.9});
  bench.command<EyebotPosition>().goTo({0.7, -0.4, 0.6}, -1.2);
  bench.advance(8.0);
  const Pose& pose = bench.robot->state().pose;
  EXPECT_NEAR(1.0 + 0.7 * std::cos(0.9) + 0.4 * std::sin(0.9), pose.position.x(), 1e-3);
  EXPECT_NEAR(2.0 + 0.7 * std::sin(0.9) - 0.4 * std::cos(0.9), pose.position.y(), 1e-3);
  EXPECT_NEAR(1.1, pose.position.z(), 1e-3);
  EXPECT_NEAR(-0.3, pose.yaw, 1e-3);
  bench.command<EyebotPosition>().land();
  bench.advance(8.0);
  EXPECT_EQ(0.0, pose.position.z());
}

TEST(MockEyebotPosition, LeavesTheRobotToVelocitiesWhenItHovers) {
  Bench bench("eyebot");
  bench.command<EyebotVelocity>().linear = {0.2, 0.0, 0.0};
  bench.advance(1.0);
  EXPECT_NEAR(0.2, bench.robot->state().pose.position.x(), 1e-9);
  bench.command<EyebotPosition>().takeOff(0.0);
  bench.advance(1.0);
  EXPECT_NEAR(0.2, bench.robot->state().pose.position.x(), 0.03) << "velocities have no effect meanwhile";
  bench.command<EyebotPosition>().hover();
  bench.advance(1.0);
  EXPECT_NEAR(0.4, bench.robot->state().pose.position.x(), 0.03);
}

TEST(MockWorld, SaysWhatWheelsARobotHas) {
  Configuration values("world", "", {"/w", 0});
  EXPECT_EQ(0.029, readWorld(values).wheels.radius) << "the usual ones";
  Configuration& wheels = values.add(Configuration("wheels", "", {"/w", 0}));
  wheels.set("radius", "0.02");
  EXPECT_EQ(0.02, readWorld(values).wheels.radius);
  EXPECT_EQ(0.14, readWorld(values).wheels.separation);
  wheels.set("separation", "0");
  EXPECT_THROW(readWorld(values), ConfigError);
}

}  // namespace
}  // namespace swarmanoid::mock
