// Encoders and odometry of any robot, from its wheel turns; a tick is 0.1 s.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/odometry.hpp"
#include "swarmanoid_interface/devices/wheel_encoders.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid::test {
namespace {

constexpr double kTurnTick = 0.1;       // s
constexpr double kWheelRadius = 0.029;  // m, of a footbot's wheels
constexpr double kSeparation = 0.14;    // m

template <class Device>
class WheelTurnTest : public testing::Test {
 protected:
  explicit WheelTurnTest(const Parameters& parameters = {}) : sensor(world, robot, parameters) {}

  /// Readings after a tick in which the wheels turn by these angles [rad].
  const Device& turn(double left, double right) {
    WheelTurns& turns = world.space.wheel_turns[robot];
    turns.left += left;
    turns.right += right;
    ++world.space.tick;
    return sensor.sense();
  }

  DeviceWorld world;
  Row robot = world.addFootbot(4.0, 5.0, 0.7);
  SensorUnderTest<Device> sensor;
};

using WheelEncodersTest = WheelTurnTest<WheelEncoders>;
using OdometryTest = WheelTurnTest<Odometry>;

TEST_F(WheelEncodersTest, CountWhatWheelsTurnSinceTheStartAndInATick) {
  EXPECT_EQ(sensor.sense().left.turned, 0.0);
  turn(0.31, -0.07);
  const WheelEncoders& readings = turn(0.42, 0.05);
  EXPECT_NEAR(readings.left.turned, 0.73, 1e-12);
  EXPECT_NEAR(readings.left.step, 0.42, 1e-12);
  EXPECT_NEAR(readings.left.speed, 4.2, 1e-11);
  EXPECT_NEAR(readings.right.turned, -0.02, 1e-12);
  EXPECT_NEAR(readings.right.step, 0.05, 1e-12);
  EXPECT_NEAR(readings.right.speed, 0.5, 1e-11);
  sensor.sense();
  EXPECT_NEAR(readings.left.step, 0.42, 1e-12) << "a tick that is made again";
  turn(0.0, 0.0);
  EXPECT_EQ(readings.left.step, 0.0);
  EXPECT_NEAR(readings.left.turned, 0.73, 1e-12);
}

TEST_F(WheelEncodersTest, SeeNothingOfBeingCarriedAway) {
  turn(0.31, 0.31);
  world.pose(robot).position.x() += 2.0;
  world.space.placed[robot] = world.space.tick + 1;
  EXPECT_EQ(turn(0.0, 0.0).left.step, 0.0);
}

TEST(WheelEncoderStepsTest, AreWholeOnesTowardsMinusInfinity) {
  DeviceWorld world;
  const Row robot = world.addFootbot(4.0, 5.0);
  world.space.wheel_turns[robot] = {17.0, -3.0};  // before the sensor is added
  SensorUnderTest<WheelEncoders> sensor(world, robot, {{"ticks_per_turn", "40"}});
  const double step = 2.0 * M_PI / 40.0;
  sensor.sense();
  ++world.space.tick;
  world.space.wheel_turns[robot].left += 2.7 * step;
  world.space.wheel_turns[robot].right -= 0.1 * step;
  const WheelEncoders& readings = sensor.sense();
  EXPECT_NEAR(readings.left.turned, 2.0 * step, 1e-12);
  EXPECT_NEAR(readings.right.turned, -step, 1e-12) << "it is below 0 already";
  ++world.space.tick;
  world.space.wheel_turns[robot].left += 0.4 * step;
  sensor.sense();
  EXPECT_NEAR(readings.left.turned, 3.0 * step, 1e-12);
  EXPECT_NEAR(readings.left.speed, step / kTurnTick, 1e-11);
  EXPECT_EQ(readings.right.step, 0.0);
}

TEST_F(OdometryTest, FollowsAnArcExactlyInOneTickAsInMany) {
  // 2.3 rad to the left around a centre 0.37 m away
  constexpr double kTurn = 2.3;
  constexpr double kArc = 0.37;
  const double left = (kArc - 0.5 * kSeparation) * kTurn / kWheelRadius;
  const double right = (kArc + 0.5 * kSeparation) * kTurn / kWheelRadius;
  constexpr int kPieces = 7;
  for (int i = 0; i < kPieces; ++i) {
    turn(left / kPieces, right / kPieces);
  }
  const Odometry many = sensor.sense();
  DeviceWorld other;
  const Row row = other.addFootbot(1.0, 1.0);
  SensorUnderTest<Odometry> once(other, row);
  ++other.space.tick;
  other.space.wheel_turns[row] = {left, right};
  const Odometry& one = once.sense();
  for (const Odometry* readings : {&many, &one}) {
    EXPECT_NEAR(readings->x, kArc * std::sin(kTurn), 1e-12) << "in the frame of the start, not of the arena";
    EXPECT_NEAR(readings->y, kArc * (1.0 - std::cos(kTurn)), 1e-12);
    EXPECT_NEAR(readings->heading, kTurn, 1e-12);
  }
  EXPECT_NEAR(one.speed, kArc * kTurn / kTurnTick, 1e-9);
  EXPECT_NEAR(many.turn_rate, kTurn / kPieces / kTurnTick, 1e-9);
  turn(0.0, 0.0);
  EXPECT_EQ(sensor.sense().speed, 0.0);
}

TEST_F(OdometryTest, HeadingStaysWithinATurn) {
  const double quarter = 0.5 * M_PI * 0.5 * kSeparation / kWheelRadius;
  for (int i = 0; i < 3; ++i) {
    turn(-quarter, quarter);
  }
  EXPECT_NEAR(sensor.sense().heading, -0.5 * M_PI, 1e-12) << "three quarters of a turn";
  EXPECT_NEAR(sensor.sense().x, 0.0, 1e-12);
}

/// Straight ahead by s: both wheel ways have the variance k^2 s, so their mean has half of it. The heading has the
/// variance 2 k^2 s / d^2. The lateral position integrates the heading errors over the way: a third of s^2 times the
/// variance of the heading.
TEST_F(OdometryTest, CovarianceGrowsWithTheWay) {
  constexpr int kTicks = 1000;
  constexpr double kWay = 0.8;
  for (int i = 0; i < kTicks; ++i) {
    turn(kWay / kTicks / kWheelRadius, kWay / kTicks / kWheelRadius);
  }
  const auto& covariance = sensor.sense().covariance;
  constexpr double kSlip = 0.01;
  const double heading = 2.0 * kSlip * kSlip * kWay / (kSeparation * kSeparation);
  EXPECT_NEAR(covariance[0], 0.5 * kSlip * kSlip * kWay, 1e-9);
  EXPECT_NEAR(covariance[8], heading, 1e-9);
  EXPECT_NEAR(covariance[4], heading * kWay * kWay / 3.0, 2e-6);
  EXPECT_NEAR(covariance[5], heading * kWay / 2.0, 1e-5);
  EXPECT_EQ(covariance[5], covariance[7]);
  EXPECT_NEAR(covariance[1], 0.0, 1e-12);
}

/// The drawn slip has the covariance that is assumed, if both parameters are equal.
TEST(OdometrySlipTest, IsDrawnAsTheCovarianceSays) {
  constexpr int kRobots = 400;
  constexpr int kTicks = 50;
  constexpr double kWay = 0.02;  // m, of a tick
  DeviceWorld world;
  const auto sensor =
      makeDevice<Sensor>(PluginKind::kSensor, "odometry", {{"slip", "0.006"}, {"assumed_slip", "0.006"}});
  std::vector<const Odometry*> readings;
  std::vector<Row> rows;
  for (int i = 0; i < kRobots; ++i) {
    rows.push_back(world.addFootbot(1.0, 1.0));
    readings.push_back(static_cast<const Odometry*>(sensor->add(world.space, rows.back())));
  }
  for (int i = 0; i < kTicks; ++i) {
    ++world.space.tick;
    for (const Row row : rows) {
      world.space.wheel_turns[row].left += kWay / kWheelRadius;
      world.space.wheel_turns[row].right += kWay / kWheelRadius;
    }
    world.sense(*sensor);
  }
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> heading;
  for (const Odometry* odometry : readings) {
    x.push_back(odometry->x);
    y.push_back(odometry->y);
    heading.push_back(odometry->heading);
  }
  const auto& covariance = readings[0]->covariance;
  const double allowed = 0.12;  // three standard errors of a deviation from 400 samples
  EXPECT_NEAR(Statistics(heading).deviation / std::sqrt(covariance[8]), 1.0, allowed);
  EXPECT_NEAR(Statistics(y).deviation / std::sqrt(covariance[4]), 1.0, allowed);
  EXPECT_NEAR(Statistics(x).mean, 1.0, 0.005);
  EXPECT_NEAR(Statistics(y).mean, 0.0, 3.0 * std::sqrt(covariance[4] / kRobots));
}

/// A robot that stood still before slips like one that drove: each tick has its own draws.
TEST(OdometrySlipTest, OfATickDoesNotDependOnTicksBefore) {
  const auto speeds = [](double before) {
    DeviceWorld world(11);
    const Row row = world.addFootbot(1.0, 1.0);
    SensorUnderTest<Odometry> sensor(world, row, {{"slip", "0.02"}});
    std::vector<double> all;
    for (const double turn : {before, 0.25}) {
      ++world.space.tick;
      world.space.wheel_turns[row].left += turn;
      world.space.wheel_turns[row].right += turn;
      all.push_back(sensor.sense().speed);
    }
    return all;
  };
  EXPECT_NEAR(speeds(0.0)[1], speeds(0.25)[1], 1e-12);
  EXPECT_GT(std::abs(speeds(0.25)[0] - speeds(0.25)[1]), 1e-6) << "another tick, another draw";
}

TEST(OdometrySlipTest, IsTheSameInWhateverRanges) {
  const auto run = [](bool is_split) {
    DeviceWorld world(7);
    const auto sensor = makeDevice<Sensor>(PluginKind::kSensor, "odometry", {{"slip", "0.02"}});
    std::vector<Row> rows;
    std::vector<const Odometry*> readings;
    for (int i = 0; i < 5; ++i) {
      rows.push_back(world.addFootbot(1.0 + i, 1.0));
      readings.push_back(static_cast<const Odometry*>(sensor->add(world.space, rows.back())));
    }
    for (int tick = 0; tick < 10; ++tick) {
      ++world.space.tick;
      for (const Row row : rows) {
        world.space.wheel_turns[row].right += 0.3;
      }
      if (is_split) {
        sensor->update(world.space, 2, 5);
        sensor->update(world.space, 0, 2);
        sensor->update(world.space, 0, 5);  // repeated
      } else {
        sensor->update(world.space, 0, 5);
      }
    }
    std::vector<double> all;
    for (const Odometry* odometry : readings) {
      all.insert(all.end(), {odometry->x, odometry->y, odometry->heading});
    }
    return all;
  };
  EXPECT_EQ(run(false), run(true));
  EXPECT_NE(run(false)[0], run(false)[3]) << "each robot slips by itself";
}

TEST_F(OdometryTest, SensingAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  const long before = heap_allocations;
  for (int i = 0; i < 3; ++i) {
    ++world.space.tick;
    sensor.sensor->sense(world.space, 0, 1);
  }
  EXPECT_EQ(heap_allocations - before, 0);
}

TEST(WheelTurnRefusalTest, RobotsWithoutWheelsAreRefused) {
  EXPECT_EQ(refusalOf<SensorUnderTest<WheelEncoders>>(robotModel("eyebot")),
            "found the device 'wheel_encoders' on a eyebot, allowed: on robots with wheels");
  EXPECT_EQ(refusalOf<SensorUnderTest<Odometry>>(robotModel("eyebot")),
            "found the device 'odometry' on a eyebot, allowed: on robots with wheels");
  EXPECT_EQ(refusalOf<SensorUnderTest<Odometry>>(robotModel("footbot")), "");
}

}  // namespace
}  // namespace swarmanoid::test
