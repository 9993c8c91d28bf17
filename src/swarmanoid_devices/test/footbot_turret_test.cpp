// The turret's commands after limits, noise and checks, and the readings of its encoder.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"

namespace swarmanoid::test {
namespace {

using Turret = ActuatorUnderTest<FootbotTurret>;
using State = SensorUnderTest<FootbotTurretState>;
using Mode = FootbotTurret::Mode;

constexpr double kMaxTurretSpeed = 3.0;  // rad/s

TEST(FootbotTurretTest, HoldsStraightUntilItIsCommanded) {
  DeviceWorld world;
  Turret turret(world, world.addFootbot(1.0, 1.0));
  EXPECT_EQ(turret.actuate().mode, Mode::kAngle);
  EXPECT_EQ(turret.actuate().angle, 0.0);
}

TEST(FootbotTurretTest, SpeedsAreLimitedToTheJoints) {
  DeviceWorld world;
  Turret turret(world, world.addFootbot(1.0, 1.0));
  for (const auto& [command, expected] :
       {std::pair(1.2, 1.2), std::pair(-1.2, -1.2), std::pair(kMaxTurretSpeed, kMaxTurretSpeed),
        std::pair(3.1, kMaxTurretSpeed), std::pair(-1e300, -kMaxTurretSpeed)}) {
    turret.command.turnAt(command);
    EXPECT_EQ(turret.actuate().mode, Mode::kSpeed);
    EXPECT_EQ(turret.actuate().speed, expected);
  }
  turret.command.holdAngle(7.5);
  EXPECT_EQ(turret.actuate().angle, 7.5) << "any angle is one of the circle";
  turret.command.letTurn();
  EXPECT_EQ(turret.actuate().mode, Mode::kPassive);
}

TEST(FootbotTurretTest, ANumberThatIsNoneHoldsStraightAndIsReported) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    DeviceWorld world;
    const Row robot = world.addFootbot(1.0, 1.0);
    Turret turret(world, robot);
    turret.command.turnAt(bad);
    EXPECT_EQ(turret.actuate().mode, Mode::kAngle);
    EXPECT_EQ(turret.actuate().angle, 0.0);
    EXPECT_EQ(turret.faulty, std::vector<Row>{robot});
  }
}

std::vector<double> speeds(const std::string& noise, std::uint64_t seed = 1, int ticks = 5000) {
  DeviceWorld world(seed);
  Turret turret(world, world.addFootbot(1.0, 1.0), {{"noise", noise}});
  turret.command.turnAt(1.0);
  std::vector<double> result;
  for (int i = 0; i < ticks; ++i, ++world.space.tick) {
    result.push_back(turret.actuate().speed);
  }
  return result;
}

TEST(FootbotTurretTest, NoiseHasTheStatedDeviation) {
  const Statistics speed(speeds("0.1"));
  EXPECT_NEAR(speed.mean, 1.0, 5.0 * 0.1 / std::sqrt(5000.0));
  EXPECT_NEAR(speed.deviation, 0.1, 5.0 * 0.1 / std::sqrt(2.0 * 5000.0));
  EXPECT_EQ(speeds("0.1", 1, 50), speeds("0.1", 1, 50));
  EXPECT_NE(speeds("0.1", 1, 50), speeds("0.1", 2, 50));
  DeviceWorld world;
  Turret turret(world, world.addFootbot(1.0, 1.0), {{"noise_angle", "2"}});
  turret.command.holdAngle(0.5);
  std::vector<double> angles;
  for (int i = 0; i < 5000; ++i, ++world.space.tick) {
    angles.push_back(turret.actuate().angle);
  }
  const double expected = 2.0 * M_PI / 180.0;
  EXPECT_NEAR(Statistics(angles).mean, 0.5, 5.0 * expected / std::sqrt(5000.0));
  EXPECT_NEAR(Statistics(angles).deviation, expected, 5.0 * expected / std::sqrt(2.0 * 5000.0));
}

TEST(FootbotTurretStateTest, ReadsTheJoint) {
  DeviceWorld world;
  const Row other = world.addFootbot(2.0, 1.0);
  const Row robot = world.addFootbot(1.0, 1.0);
  State state(world, robot);
  EXPECT_EQ(state.sense().angle, 0.0);
  world.space.joints[other][0] = {9.0, 9.0, 9.0};
  world.space.joints[robot][0] = {-0.3, 0.2, 1.5};
  EXPECT_EQ(state.sense().angle, -0.3);
  EXPECT_EQ(state.sense().speed, 0.2);
  EXPECT_EQ(state.sense().torque, 1.5);
}

TEST(FootbotTurretStateTest, NoiseHasTheStatedDeviation) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  State state(world, robot, {{"noise", "3"}, {"noise_torque", "0.2"}});
  world.space.joints[robot][0] = {M_PI, 0.2, 1.5};
  std::vector<double> angles;
  std::vector<double> torques;
  for (int i = 0; i < 5000; ++i, ++world.space.tick) {
    const FootbotTurretState& read = state.sense();
    EXPECT_LE(std::abs(read.angle), M_PI);
    EXPECT_EQ(read.speed, 0.2);
    angles.push_back(std::remainder(read.angle - M_PI, 2.0 * M_PI));
    torques.push_back(read.torque);
  }
  const double expected = 3.0 * M_PI / 180.0;
  EXPECT_NEAR(Statistics(angles).mean, 0.0, 5.0 * expected / std::sqrt(5000.0));
  EXPECT_NEAR(Statistics(angles).deviation, expected, 5.0 * expected / std::sqrt(2.0 * 5000.0));
  EXPECT_NEAR(Statistics(torques).deviation, 0.2, 5.0 * 0.2 / std::sqrt(2.0 * 5000.0));
}

}  // namespace
}  // namespace swarmanoid::test
