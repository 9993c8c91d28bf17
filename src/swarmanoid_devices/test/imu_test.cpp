// The inertial measurement unit: turn rates and proper acceleration in the robot's frame, from the velocities of two
// ticks, 0.1 s apart.
#include "swarmanoid_interface/devices/imu.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kGravity = 9.81;  // m/s2
constexpr double kTick = 0.1;      // s

Eigen::Quaterniond turned(double angle, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

void expectNear(const Eigen::Vector3d& found, const Eigen::Vector3d& expected, const std::string& what,
                double allowed = 1e-9) {
  EXPECT_NEAR((found - expected).norm(), 0.0, allowed)
      << what << ": found " << found.transpose() << ", expected " << expected.transpose();
}

class ImuTest : public testing::Test {
 protected:
  void set(const Eigen::Quaterniond& orientation, const Eigen::Vector3d& velocity,
           const Eigen::Vector3d& angular_velocity) {
    world.pose(robot).orientation = orientation;
    world.space.entities.twist[robot] = {velocity, angular_velocity};
  }
  /// Readings of the next tick, with the state that was set.
  const Imu& next() {
    ++world.space.tick;
    return imu.sense();
  }

  DeviceWorld world;
  Row robot = world.addFootbot(4.0, 5.0);
  SensorUnderTest<Imu> imu{world, robot};
};

TEST_F(ImuTest, AtRestItFeelsGravityUpwards) {
  expectNear(imu.sense().angular_velocity, Eigen::Vector3d::Zero(), "turning");
  expectNear(imu.sense().linear_acceleration, {0.0, 0.0, kGravity}, "acceleration");
  set(turned(0.3, Eigen::Vector3d::UnitY()), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());  // nose down
  next();
  expectNear(next().linear_acceleration, {-kGravity * std::sin(0.3), 0.0, kGravity * std::cos(0.3)}, "on a slope");
}

TEST_F(ImuTest, AnyOfTheThreeRobotsHasIt) {
  for (const char* type : {"footbot", "eyebot", "handbot"}) {
    const Row another = world.add(robotModel(type), {1.0, 2.0, 0.5});
    world.pose(another).orientation = turned(-0.41, Eigen::Vector3d::UnitX());  // its left side is down
    SensorUnderTest<Imu> sensor(world, another);
    expectNear(sensor.sense().linear_acceleration, {0.0, -kGravity * std::sin(0.41), kGravity * std::cos(0.41)}, type);
  }
}

TEST_F(ImuTest, OnACircleItFeelsSpeedTimesTurnRateInwards) {
  constexpr double kSpeed = 0.27;     // m/s
  constexpr double kTurnRate = -1.3;  // rad/s, to the right
  for (int tick = 0; tick < 20; ++tick) {
    const double heading = 0.4 + kTurnRate * kTick * tick;
    set(turned(heading, Eigen::Vector3d::UnitZ()), {kSpeed * std::cos(heading), kSpeed * std::sin(heading), 0.0},
        {0.0, 0.0, kTurnRate});
    const Imu& readings = next();
    expectNear(readings.angular_velocity, {0.0, 0.0, -1.3}, "turning");
    expectNear(readings.linear_acceleration, {0.0, -0.351, kGravity}, "0.27 * 1.3 to the right");
  }
}

TEST_F(ImuTest, SpeedingUpAndBrakingAreFeltAlongTheWay) {
  const Eigen::Quaterniond orientation = turned(0.9, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d ahead(std::cos(0.9), std::sin(0.9), 0.0);
  set(orientation, 0.1 * ahead, Eigen::Vector3d::Zero());
  expectNear(next().linear_acceleration, {0.0, 0.0, kGravity}, "the first tick knows nothing of before");
  set(orientation, 0.16 * ahead, Eigen::Vector3d::Zero());
  expectNear(next().linear_acceleration, {0.6, 0.0, kGravity}, "0.06 m/s in 0.1 s");
  set(orientation, 0.16 * ahead, Eigen::Vector3d::Zero());
  expectNear(next().linear_acceleration, {0.0, 0.0, kGravity}, "steady");
  set(orientation, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  expectNear(next().linear_acceleration, {-1.6, 0.0, kGravity}, "stopped");
}

TEST_F(ImuTest, SpinningAboutATiltedAxisItsAxesSeeTheSpinAndGravityTurn) {
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  constexpr double kSpin = 2.1;  // rad/s
  const Eigen::Quaterniond start = turned(0.7, Eigen::Vector3d::UnitX());
  Eigen::Vector3d up_before = start.conjugate() * Eigen::Vector3d::UnitZ();
  for (int tick = 0; tick < 20; ++tick) {
    const Eigen::Quaterniond orientation = turned(kSpin * kTick * tick, axis) * start;
    set(orientation, Eigen::Vector3d::Zero(), kSpin * axis);
    const Imu& readings = next();
    const Eigen::Vector3d up = orientation.conjugate() * Eigen::Vector3d::UnitZ();
    expectNear(readings.angular_velocity, start.conjugate() * (kSpin * axis), "the axis of a spin stays where it is");
    expectNear(readings.linear_acceleration, 0.5 * kGravity * (up_before + up), "gravity, in the mean of the tick");
    up_before = up;
  }
}

TEST_F(ImuTest, InFreeFallItFeelsNothing) {
  const Eigen::Quaterniond orientation = turned(1.1, Eigen::Vector3d(0.0, 0.6, 0.8));
  for (int tick = 0; tick < 5; ++tick) {
    set(orientation, {0.3, 0.2, -kGravity * kTick * tick}, Eigen::Vector3d::Zero());
    const Imu& readings = next();
    if (tick > 0) {
      expectNear(readings.linear_acceleration, Eigen::Vector3d::Zero(), "free fall");
    }
  }
}

/// A tumbling body in free fall turns by 0.21 rad in a tick. Two velocities determine the acceleration in between to
/// second order: the error is g * 0.21^2 / 4, and grows slightly with the falling speed.
TEST_F(ImuTest, FallingAndTumblingItFeelsNextToNothing) {
  for (int tick = 0; tick < 5; ++tick) {
    set(turned(0.21 * tick, Eigen::Vector3d::UnitY()), {0.0, 0.0, -kGravity * kTick * tick}, {0.0, 2.1, 0.0});
    const Imu& readings = next();
    if (tick > 0) {
      expectNear(readings.linear_acceleration, Eigen::Vector3d::Zero(), "tumbling", 0.12);
    }
  }
}

/// The exchange with other processes may be aborted after sensing, because of an action on the space, and repeated.
TEST_F(ImuTest, ATickThatIsMadeAgainReadsTheSame) {
  set(Eigen::Quaterniond::Identity(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  next();
  set(Eigen::Quaterniond::Identity(), {0.05, 0.0, 0.0}, Eigen::Vector3d::Zero());
  expectNear(next().linear_acceleration, {0.5, 0.0, kGravity}, "once");
  expectNear(imu.sense().linear_acceleration, {0.5, 0.0, kGravity}, "again");
  set(Eigen::Quaterniond::Identity(), {0.02, 0.0, 0.0}, Eigen::Vector3d::Zero());
  expectNear(imu.sense().linear_acceleration, {0.2, 0.0, kGravity}, "after somebody has acted");
  expectNear(next().linear_acceleration, {0.0, 0.0, kGravity}, "and from there on");
}

/// Moving a robot from outside stops it; that is no acceleration.
TEST_F(ImuTest, BeingPutElsewhereIsNotFelt) {
  set(Eigen::Quaterniond::Identity(), {0.3, 0.0, 0.0}, {0.0, 0.0, 1.4});
  next();
  world.space.placed[robot] = world.space.tick + 1;  // the next tick
  set(turned(0.3, Eigen::Vector3d::UnitY()), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  const Eigen::Vector3d at_rest(-kGravity * std::sin(0.3), 0.0, kGravity * std::cos(0.3));
  expectNear(next().linear_acceleration, at_rest, "put on a slope");
  expectNear(imu.sense().linear_acceleration, at_rest, "the tick made again");
  set(turned(0.3, Eigen::Vector3d::UnitY()), turned(0.3, Eigen::Vector3d::UnitY()) * Eigen::Vector3d(0.02, 0.0, 0.0),
      Eigen::Vector3d::Zero());
  expectNear(next().linear_acceleration, at_rest + Eigen::Vector3d(0.2, 0.0, 0.0), "what comes then is felt");
}

TEST_F(ImuTest, ARobotThatTakesTheRowOfAnotherBeginsAnew) {
  set(Eigen::Quaterniond::Identity(), {0.3, 0.0, 0.0}, Eigen::Vector3d::Zero());
  next();
  const Row other = world.addFootbot(7.0, 7.0);
  const auto* others = static_cast<const Imu*>(imu.sensor->add(world.space, other));
  imu.sensor->remove(world.space, robot);
  world.remove(robot);
  const Row late = world.addFootbot(1.0, 1.0);
  ASSERT_EQ(late, robot) << "the row is used again";
  const auto* lates = static_cast<const Imu*>(imu.sensor->add(world.space, late));
  ++world.space.tick;
  world.sense(*imu.sensor);
  expectNear(lates->linear_acceleration, {0.0, 0.0, kGravity}, "it never moved");
  world.space.entities.twist[other].linear.x() = 0.1;
  ++world.space.tick;
  world.sense(*imu.sensor);
  expectNear(others->linear_acceleration, {1.0, 0.0, kGravity}, "the other one");
  expectNear(lates->linear_acceleration, {0.0, 0.0, kGravity}, "still at rest");
}

TEST_F(ImuTest, SensingAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  const long before = heap_allocations;
  imu.sensor->sense(world.space, 0, 1);
  ++world.space.tick;
  imu.sensor->sense(world.space, 0, 1);
  EXPECT_EQ(heap_allocations - before, 0);
  EXPECT_GT(before, 0) << "the counting works";
}

}  // namespace
}  // namespace swarmanoid::test
