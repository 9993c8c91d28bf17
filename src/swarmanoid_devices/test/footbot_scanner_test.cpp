// The rotating distance scanner: four beams from the robot's axis, 0.13 m above the ground, turned by the head angle.
#include "swarmanoid_interface/devices/footbot_scanner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "device_world.hpp"
#include "swarmanoid_space/device_drawing.hpp"

namespace swarmanoid::test {
namespace {

using Readings = FootbotScannerReadings;

constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr double kTick = 0.1;  // s, of DeviceWorld

/// A footbot with its scanner.
struct Scanning {
  explicit Scanning(DeviceWorld& in, double x, double y, double heading, const Errors& errors = {})
      : world(in), row(in.addFootbot(x, y, heading)), scanner(in, row), sensor(in, row, {}, errors) {}

  /// Applies the command, advances a tick, and senses.
  const Readings& tick() {
    scanner.actuate();
    ++world.space.tick;
    return sensor.sense();
  }

  DeviceWorld& world;
  Row row;
  ActuatorUnderTest<FootbotScanner> scanner;
  SensorUnderTest<Readings> sensor;
};

void expectAngle(double expected, double found) {
  EXPECT_NEAR(0.0, std::remainder(expected - found, 2.0 * M_PI), 1e-6) << expected << " and " << found;
}

TEST(FootbotScannerTest, TurnsEvenlyAndMeasuresAWallWithAllBeams) {
  DeviceWorld world;
  Scanning robot(world, 4.0, 5.0, 0.53);
  world.addWall({0.1, 8.0, 0.5}, {4.0 + 0.27 + 0.05, 5.0});
  robot.scanner.command.turnAt(1.7);
  int short_distances = 0;
  int long_distances = 0;
  for (int tick = 1; tick <= 50; ++tick) {
    const Readings& readings = robot.tick();
    expectAngle(1.7 * kTick * tick, readings.angle);
    EXPECT_FLOAT_EQ(0.1F, readings.period);
    for (std::size_t i = 0; i < Readings::kSamples; ++i) {
      const double head = 1.7 * kTick * (tick - 1 + (static_cast<double>(i) + 1.0) / 8.0);
      expectAngle(head, readings.angles[i]);
      for (std::size_t beam = 0; beam < Readings::kBeams; ++beam) {
        const double cosine = std::cos(0.53 + head + static_cast<double>(beam) * M_PI / 2.0);
        const double distance = cosine > 0.0 ? 0.27 / cosine : kInfinity;
        const double range = beam % 2 == 1 ? 1.5 : 0.3;
        const float found = readings.distances(beam)[i];
        if (distance > range) {
          EXPECT_EQ(kNothing, found) << distance;
        } else {
          EXPECT_NEAR(distance, found, 2e-6);
          ++(beam % 2 == 1 ? long_distances : short_distances);
        }
      }
    }
  }
  // 400 samples of two beams each over 8.5 rad: 156 degrees of a turn, and then 52 degrees, face the wall
  EXPECT_NEAR(800.0 * 2.0 * std::acos(0.27 / 1.5) / (2.0 * M_PI), long_distances, 60.0);
  EXPECT_NEAR(800.0 * 2.0 * std::acos(0.27 / 0.3) / (2.0 * M_PI), short_distances, 60.0);
}

TEST(FootbotScannerTest, LongBeamsAreBlindWhereShortOnesMeasure) {
  DeviceWorld world;
  Scanning robot(world, 4.0, 5.0, 0.0);
  const Row wall = world.addWall({0.1, 8.0, 0.5}, {4.0 + 0.19 + 0.05, 5.0});
  robot.scanner.command.holdAngle(0.0);
  EXPECT_NEAR(0.19, robot.tick().short_ahead[7], 1e-6);
  EXPECT_EQ(kNothing, robot.tick().long_left[0]);
  robot.scanner.command.holdAngle(M_PI / 2.0);
  robot.tick();
  robot.tick();
  const Readings& across = robot.tick();
  EXPECT_NEAR(M_PI / 2.0, across.angle, 1e-12);
  EXPECT_EQ(-kNothing, across.long_right[0]) << "faces the wall, which is too close";
  EXPECT_EQ(kNothing, across.short_ahead[0]);
  world.pose(wall).position.x() += 0.0201;
  EXPECT_NEAR(0.2101, robot.tick().long_right[7], 1e-6);
  world.pose(wall).position.x() = 4.0 + 0.0399 + 0.05;
  robot.scanner.command.holdAngle(0.0);
  robot.tick();
  robot.tick();
  EXPECT_EQ(-kNothing, robot.tick().short_ahead[7]);
}

TEST(FootbotScannerTest, SeesOtherFootbotsAtTheirHullsAndLooksOverPreys) {
  DeviceWorld world;
  Scanning robot(world, 4.0, 5.0, -0.4);
  const double way = -0.4 + 0.3 + M_PI / 2.0;  // direction of beam 1 with the head at 0.3 rad
  world.addPrey(4.0 + 0.3 * std::cos(way), 5.0 + 0.3 * std::sin(way));
  world.addFootbot(4.0 + 0.7 * std::cos(way), 5.0 + 0.7 * std::sin(way), 1.0);
  world.addWall({0.1, 0.1, 0.5}, {4.0 + 1.2 * std::cos(way), 5.0 + 1.2 * std::sin(way)});  // behind it
  robot.scanner.command.holdAngle(0.3);
  robot.tick();
  const Readings& readings = robot.tick();
  EXPECT_NEAR(0.7 - 0.085, readings.long_left[3], 1e-6);
  EXPECT_EQ(kNothing, readings.long_right[3]);
  EXPECT_EQ(kNothing, readings.short_behind[3]);
  world.addPrey(4.0 + 0.31 * std::cos(way), 5.0 + 0.31 * std::sin(way), colors::kBlack, 0.02, 0.2);
  EXPECT_NEAR(0.29, robot.tick().long_left[3], 1e-6) << "a pole that is high enough";
}

TEST(FootbotScannerTest, ATiltedRobotMeasuresTheFloorAndARamp) {
  DeviceWorld world;
  Scanning robot(world, 4.0, 5.0, 0.0);
  world.pose(robot.row).orientation = Eigen::AngleAxisd(0.15, Eigen::Vector3d::UnitX());  // leans to its right
  robot.scanner.command.holdAngle(0.0);
  const Readings& readings = robot.tick();
  EXPECT_NEAR(0.13 * std::cos(0.15) / std::sin(0.15), readings.long_right[7], 1e-6);
  EXPECT_EQ(kNothing, readings.long_left[7]);
  EXPECT_EQ(kNothing, readings.short_ahead[7]);
  world.pose(robot.row).orientation = Eigen::Quaterniond::Identity();
  world.space.terrain = std::make_shared<const Terrain>(Eigen::Vector2d(4.0, 5.1), Eigen::Vector2d(1.0, 1.0), 2, 2,
                                                        std::vector<double>{0.0, 0.0, 0.4, 0.4});
  robot.scanner.command.holdAngle(0.0);
  world.pose(robot.row).position.x() = 4.3;
  EXPECT_NEAR(0.1 + 0.13 / 0.4, robot.tick().long_left[7], 1e-6);
}

TEST(FootbotScannerTest, OffItStandsAndMeasuresNothing) {
  DeviceWorld world;
  Scanning robot(world, 4.0, 5.0, 0.0);
  world.addWall({0.1, 8.0, 0.5}, {4.25, 5.0});
  for (std::size_t beam = 0; beam < Readings::kBeams; ++beam) {
    EXPECT_TRUE(std::isnan(robot.tick().distances(beam)[4])) << "nobody has switched it on";
  }
  robot.scanner.command.turnAt(-2.3);
  robot.tick();
  EXPECT_NEAR(-0.46, robot.tick().angles[7], 1e-6);
  EXPECT_TRUE(robot.scanner.stop());
  const Readings& readings = robot.tick();
  EXPECT_NEAR(-0.46, readings.angle, 1e-12);
  EXPECT_NEAR(-0.46, readings.angles[0], 1e-6);
  EXPECT_TRUE(std::isnan(readings.short_ahead[0]));
  const Row other = world.addFootbot(2.0, 2.0);
  SensorUnderTest<Readings> alone(world, other);
  EXPECT_TRUE(std::isnan(alone.sense().long_left[0])) << "without a motor";
}

TEST(FootbotScannerTest, TurnsTheShorterWayNoFasterThanItsMotor) {
  DeviceWorld world;
  Scanning robot(world, 4.0, 5.0, 0.0);
  robot.scanner.command.turnAt(50.0);
  EXPECT_EQ(FootbotScanner::kFastest, robot.scanner.actuate().speed);
  for (int tick = 0; tick < 4; ++tick) {
    robot.tick();
  }
  expectAngle(M_PI, robot.tick().angle);
  robot.scanner.command.holdAngle(-2.9 - 2.0 * M_PI);
  EXPECT_NEAR(-2.9, robot.tick().angle, 1e-9) << "0.24 rad on";
  robot.scanner.command.holdAngle(0.0);
  EXPECT_NEAR(-2.9 + 0.2 * M_PI, robot.tick().angle, 1e-9);
  for (int tick = 0; tick < 4; ++tick) {
    robot.tick();
  }
  EXPECT_NEAR(0.0, robot.tick().angle, 1e-12) << "and stays there";
  EXPECT_NEAR(0.0, robot.tick().angles[0], 1e-12);
}

TEST(FootbotScannerTest, ATickThatIsMadeAgainTurnsFromTheSameAngle) {
  DeviceWorld world;
  Scanning robot(world, 4.0, 5.0, 0.0);
  robot.scanner.command.turnAt(1.1);
  robot.tick();
  EXPECT_NEAR(0.22, robot.tick().angle, 1e-12);
  EXPECT_NEAR(0.22, robot.sensor.sense().angle, 1e-12);
  robot.scanner.command.turnAt(-0.5);  // another source commands it in that tick
  robot.scanner.actuate();
  EXPECT_NEAR(0.06, robot.sensor.sense().angle, 1e-12);
  EXPECT_NEAR(0.01, robot.tick().angle, 1e-12);
}

TEST(FootbotScannerTest, ErrorsMoveDistancesOnlyAndADeadOneMeasuresNothing) {
  DeviceWorld world;
  world.addWall({0.1, 8.0, 0.5}, {4.0 + 0.8 + 0.05, 5.0});
  Scanning robot(world, 4.0, 5.0, 0.0, {bias("long_left", "0.6"), bias("long_right", "0.8")});
  robot.scanner.command.holdAngle(M_PI / 2.0);
  robot.tick();
  robot.tick();
  EXPECT_EQ(kNothing, robot.tick().long_left[2]) << "nothing stays nothing";
  EXPECT_EQ(kNothing, robot.tick().long_right[2]) << "1.6 m";
  ErrorModelDescription dead;
  dead.kind = "dead";
  dead.parameters = Configuration("error", "", {});
  robot.sensor.sensor->setFaults(world.space, robot.row, {dead});
  EXPECT_TRUE(std::isnan(robot.tick().short_ahead[2]));
  robot.sensor.sensor->setFaults(world.space, robot.row, {});
  EXPECT_EQ(kNothing, robot.tick().short_ahead[2]);
}

TEST(FootbotScannerTest, WhatItReadsIsDrawn) {
  DeviceWorld world;
  Scanning robot(world, 4.0, 5.0, 0.53);
  world.addWall({0.1, 8.0, 0.5}, {4.0 + 0.27 + 0.05, 5.0});
  robot.scanner.command.turnAt(1.7);
  const Readings& readings = robot.tick();
  DeviceDrawing drawing;
  robot.sensor.sensor->draw(world.space, drawing);
  // beams 0, ahead, and 3, to the right, face the wall, and only the long one reaches it: 0.27 m / cos(0.53 - pi / 2 +
  // 0.17)
  ASSERT_EQ(drawing.lines().size(), Readings::kBeams * Readings::kSamples);
  ASSERT_EQ(drawing.points().size(), Readings::kSamples);
  const Eigen::Vector3d centre(4.0, 5.0, 0.13);
  const double last = 0.53 + 0.17;
  const Eigen::Vector3d ahead(std::cos(last), std::sin(last), 0.0);
  const Eigen::Vector3d right(std::sin(last), -std::cos(last), 0.0);
  const DeviceDrawing::Line& short_one = drawing.lines()[Readings::kSamples - 1];
  EXPECT_NEAR((short_one.from - centre).norm(), 0.0, 1e-6);
  EXPECT_NEAR((short_one.to - centre - 0.3 * ahead).norm(), 0.0, 1e-6) << "nothing in range: as far as it reaches";
  EXPECT_EQ(short_one.color, DeviceDrawing::shade(0.0));
  const double way = 0.27 / std::sin(last);
  EXPECT_NEAR((drawing.points().back().place - centre - way * right).norm(), 0.0, 1e-5);
  EXPECT_EQ(drawing.points().back().color, DeviceDrawing::shade(1.0 - way / 1.5));
  EXPECT_NEAR(readings.long_right[Readings::kSamples - 1], way, 1e-5);
  robot.scanner.command.switchOff();
  robot.tick();
  drawing.clear();
  robot.sensor.sensor->draw(world.space, drawing);
  EXPECT_TRUE(drawing.lines().empty()) << "off";
}

}  // namespace
}  // namespace swarmanoid::test
