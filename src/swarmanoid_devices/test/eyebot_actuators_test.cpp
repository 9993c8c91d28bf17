// The eyebot's velocity controller and its laser pointer.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"

namespace swarmanoid::test {
namespace {

using Eigen::Vector3d;
using Velocity = ActuatorUnderTest<EyebotVelocity>;

TEST(EyebotVelocityTest, IsLimitedInLengthAndKeepsItsDirection) {
  DeviceWorld world;
  Velocity velocity(world, world.addEyebot(5.0, 5.0, 2.0), {{"max_speed", "0.5"}, {"max_yaw_rate", "1.5"}});
  velocity.command.linear = {0.3, -0.2, 0.1};
  velocity.command.yaw_rate = 1.5;
  EXPECT_EQ(velocity.actuate().linear, velocity.command.linear) << "slower than the limit";
  EXPECT_EQ(velocity.actuate().yaw_rate, 1.5);
  velocity.command.linear = {3.0, 0.0, 4.0};
  velocity.command.yaw_rate = -100.0;
  EXPECT_LT((velocity.actuate().linear - Vector3d(0.3, 0.0, 0.4)).norm(), 1e-15);
  EXPECT_EQ(velocity.actuate().yaw_rate, -1.5);
}

TEST(EyebotVelocityTest, TheLongestFiniteVelocityIsLimitedToo) {
  DeviceWorld world;
  Velocity velocity(world, world.addEyebot(5.0, 5.0, 2.0));
  for (const double speed : {1e10, 1e200, std::numeric_limits<double>::max()}) {
    velocity.command.linear = {-speed, 0.0, 0.0};
    EXPECT_LT((velocity.actuate().linear - Vector3d(-1.0, 0.0, 0.0)).norm(), 1e-15) << speed;
    velocity.command.linear = Vector3d::Constant(speed);
    EXPECT_LT((velocity.actuate().linear - Vector3d::Constant(std::sqrt(1.0 / 3.0))).norm(), 1e-12) << speed;
    EXPECT_TRUE(velocity.faulty.empty());
  }
}

TEST(EyebotVelocityTest, ANumberThatIsNoneHoversAndIsReported) {
  DeviceWorld world;
  const Row robot = world.addEyebot(5.0, 5.0, 2.0);
  Velocity velocity(world, robot, {{"noise", "0.1"}});
  velocity.command.linear.y() = std::numeric_limits<double>::infinity();
  velocity.command.yaw_rate = 1.0;
  EXPECT_EQ(velocity.actuate().linear, Vector3d::Zero());
  EXPECT_EQ(velocity.actuate().yaw_rate, 0.0);
  EXPECT_EQ(velocity.faulty, std::vector<Row>{robot});
}

std::vector<double> alongY(std::uint64_t seed, const std::string& noise) {
  DeviceWorld world(seed);
  Velocity velocity(world, world.addEyebot(5.0, 5.0, 2.0), {{"noise", noise}});
  velocity.command.linear.y() = 0.25;
  std::vector<double> result;
  for (; world.space.tick < 4000; ++world.space.tick) {
    result.push_back(velocity.actuate().linear.y());
  }
  return result;
}

TEST(EyebotVelocityTest, ASafeStopHoversAndThenComesDown) {
  DeviceWorld world;
  const Row robot = world.addEyebot(1.0, 1.0, 2.0);
  Velocity velocity(world, robot);
  velocity.command.linear = {0.2, 0.0, 0.1};
  velocity.actuate();
  const auto vertical = [&](double since, bool is_over) {
    EXPECT_EQ(is_over, velocity.stop(since)) << since;
    const EyebotVelocity& actuation = *world.space.actuation.find<EyebotVelocity>(robot);
    EXPECT_EQ(actuation.linear.x(), 0.0);
    EXPECT_EQ(actuation.linear, velocity.command.linear);
    return actuation.linear.z();
  };
  EXPECT_EQ(vertical(0.0, false), 0.0);
  EXPECT_EQ(vertical(1.9, false), 0.0);
  EXPECT_EQ(vertical(2.0, false), -0.3);
  EXPECT_EQ(vertical(9.9, false), -0.3);
  EXPECT_EQ(vertical(10.0, true), 0.0);
}

TEST(EyebotVelocityTest, NoiseHasTheStatedDeviationAndBelongsToTheSeed) {
  const Statistics statistics(alongY(1, "0.05"));
  EXPECT_NEAR(statistics.mean, 0.25, 5.0 * 0.05 / std::sqrt(4000.0));
  EXPECT_NEAR(statistics.deviation, 0.05, 0.003);
  EXPECT_EQ(alongY(1, "0.05"), alongY(1, "0.05"));
  EXPECT_NE(alongY(1, "0.05"), alongY(2, "0.05"));
  EXPECT_EQ(alongY(1, "0"), std::vector<double>(4000, 0.25));
}

/// An eyebot above (5, 5), heading along y; its laser is 5 cm ahead of its axis and 2.15 m above the ground.
class EyebotLaserTest : public testing::Test {
 protected:
  const std::vector<LaserSpot>& spots(ActuatorUnderTest<EyebotLaser>& tested) {
    world.takePoses();
    world.space.laser_spots.clear();
    tested.actuate();
    tested.actuator->afterMove(world.space, AfterMoveAccess(world.space));
    return world.space.laser_spots;
  }

  /// Returns the expected position of the spot on the floor.
  static Vector3d onFloor(double pan, double tilt) {
    const double reach = 2.15 * std::tan(tilt);
    return {5.0 - reach * std::sin(pan), 5.05 + reach * std::cos(pan), 0.0};
  }

  DeviceWorld world;
  Row robot = world.addEyebot(5.0, 5.0, 2.0, M_PI / 2.0);
  ActuatorUnderTest<EyebotLaser> laser{world, robot};
};

TEST_F(EyebotLaserTest, MakesASpotOnlyWhileItIsOn) {
  EXPECT_TRUE(spots(laser).empty());
  laser.command.on = true;
  ASSERT_EQ(spots(laser).size(), 1U);
  const LaserSpot& spot = world.space.laser_spots[0];
  EXPECT_EQ(spot.owner, EntityNumber{1});
  EXPECT_EQ(spot.color, colors::kRed);
  EXPECT_LT((spot.source - Vector3d(5.0, 5.05, 2.15)).norm(), 1e-12);
  EXPECT_LT((spot.position - Vector3d(5.0, 5.05, 0.0)).norm(), 1e-9) << "straight down, through its own body";
  laser.command.on = false;
  EXPECT_TRUE(spots(laser).empty());
}

TEST_F(EyebotLaserTest, TheSpotLiesWherePanAndTiltSay) {
  laser.command.on = true;
  for (const double pan : {0.0, 1.0, -2.0, M_PI}) {
    for (const double tilt : {0.1, 0.5, 0.8}) {
      laser.command.pan = pan;
      laser.command.tilt = tilt;
      EXPECT_LT((spots(laser).at(0).position - onFloor(pan, tilt)).norm(), 1e-9) << pan << ", " << tilt;
    }
  }
}

TEST_F(EyebotLaserTest, TiltIsLimited) {
  laser.command.on = true;
  laser.command.tilt = 1.5;
  EXPECT_LT((spots(laser).at(0).position - onFloor(0.0, 0.8)).norm(), 1e-9);
}

TEST_F(EyebotLaserTest, TheBeamEndsOnTheFirstSurface) {
  laser.command.on = true;
  world.addPrey(5.0, 5.05, colors::kYellow, 0.06, 0.1);
  EXPECT_LT((spots(laser).at(0).position - Vector3d(5.0, 5.05, 0.1)).norm(), 1e-9) << "on top of the prey";
  world.addWall({2.0, 0.2, 2.0}, {5.0, 6.15});  // its face is 1 m ahead of the laser
  laser.command.tilt = 0.8;
  EXPECT_LT((spots(laser).at(0).position - Vector3d(5.0, 6.05, 2.15 - 1.0 / std::tan(0.8))).norm(), 1e-9);
}

TEST_F(EyebotLaserTest, InAHoleThereIsNoSpot) {
  laser.command.on = true;
  FloorHole hole;
  hole.position = {5.0, 5.05, 0.0};
  hole.radius = 0.3;
  world.space.floor.holes = {hole};
  EXPECT_TRUE(spots(laser).empty());
  // the floor is 2.15 m below: 0.3 m to the side at 0.138637 rad
  laser.command.tilt = 0.1386;
  EXPECT_TRUE(spots(laser).empty());
  laser.command.tilt = 0.1387;
  EXPECT_EQ(spots(laser).size(), 1U);
  laser.command.tilt = 0.0;
  world.addPrey(5.0, 5.05, colors::kYellow, 0.06, 0.1);
  EXPECT_EQ(spots(laser).size(), 1U) << "on what stands over it";
}

TEST_F(EyebotLaserTest, ANumberThatIsNoneTurnsItOff) {
  laser.command.on = true;
  laser.command.pan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(spots(laser).empty());
  EXPECT_EQ(laser.faulty, std::vector<Row>{robot});
}

TEST_F(EyebotLaserTest, NoiseTiltsTheBeam) {
  ActuatorUnderTest<EyebotLaser> noisy(world, world.addEyebot(2.0, 2.0, 2.0), {{"noise", "1"}});
  noisy.command.on = true;
  std::vector<double> tilts;
  for (; world.space.tick < 2000; ++world.space.tick) {
    tilts.push_back(std::atan2(spots(noisy).at(0).position.x() - 2.05, 2.15));
  }
  EXPECT_NEAR(Statistics(tilts).mean, 0.0, 5.0 * 0.01745 / std::sqrt(2000.0));
  EXPECT_NEAR(Statistics(tilts).deviation, M_PI / 180.0, 0.0015);
}

}  // namespace
}  // namespace swarmanoid::test
