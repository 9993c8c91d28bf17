// The infrared ring: 24 rays from 0.085 m around the axis, 0.06 m above the ground; response (1 - distance / range)^3.
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "device_world.hpp"

namespace swarmanoid::test {
namespace {

using Ring = SensorUnderTest<FootbotProximity>;

constexpr double kFootbotRadius = 0.085;  // of the ring, m
constexpr double kRange = 0.1;            // default range, m

double response(double distance, double range = kRange) {
  return distance >= range ? 0.0 : std::pow(1.0 - distance / range, 3.0);
}

double headings[] = {0.0, 0.7, -2.5};

TEST(FootbotProximityTest, AWallAheadIsReadByEachSensorAtItsOwnDistance) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  world.addWall({0.1, 2.0, 0.5}, {1.0 + kFootbotRadius + 0.05 + 0.05, 1.0});  // its face is 5 cm from sensor 0
  const FootbotProximity& readings = Ring(world, robot).sense();
  EXPECT_NEAR(readings.value[0], 0.125, 1e-6);
  for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
    const double cosine = std::cos(FootbotProximity::angle(i));
    const double distance = cosine > 0.0 ? (kFootbotRadius + 0.05) / cosine - kFootbotRadius : kRange;
    EXPECT_NEAR(readings.value[i], response(distance), 1e-6) << "sensor " << i;
    EXPECT_EQ(readings.value[i] == 0.0F, distance >= kRange) << "sensor " << i;
  }
}

TEST(FootbotProximityTest, TheResponseIsCubicFromContactToTheRange) {
  for (const double range : {0.1, 0.3}) {
    DeviceWorld world;
    const Row robot = world.addFootbot(1.0, 1.0);
    const Row wall = world.addWall({0.1, 2.0, 0.5}, {2.0, 1.0});
    Ring ring(world, robot, {{"range", std::to_string(range)}});
    for (const double distance : {0.0, 0.01, 0.05, 0.0999, 0.1, 0.2, 0.299, 0.301, 0.5}) {
      // on the robot's left, where no other part of it protrudes
      world.pose(robot).orientation = Eigen::AngleAxisd(-M_PI / 2.0, Eigen::Vector3d::UnitZ());
      world.pose(wall).position.x() = 1.0 + kFootbotRadius + distance + 0.05;
      EXPECT_NEAR(ring.sense().value[6], response(distance, range), 1e-6) << distance << " m";
    }
  }
}

TEST(FootbotProximityTest, DistancesAreReadByTheLawOfTheDevice) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  world.pose(robot).orientation = Eigen::AngleAxisd(-M_PI / 2.0, Eigen::Vector3d::UnitZ());
  const Row wall = world.addWall({0.1, 2.0, 0.5}, {2.0, 1.0});
  Ring ring(world, robot);
  for (const double distance : {0.0, 0.0137, 0.0271, 0.0613, 0.0891, 0.0999, 0.1003, 0.7}) {
    world.pose(wall).position.x() = 1.0 + kFootbotRadius + distance + 0.05;
    const float expected = Proximity::response(std::min(distance / kRange, 1.0));
    EXPECT_NEAR(expected, ring.sense().value[6], 1e-6) << distance << " m";
  }
}

/// Adds obstacles around a robot, near and far.
void standAround(DeviceWorld& world, std::mt19937& random) {
  std::uniform_real_distribution<double> place(4.4, 5.6);
  std::uniform_real_distribution<double> size(0.02, 0.5);
  std::uniform_real_distribution<double> heading(-M_PI, M_PI);
  world.addFootbot(place(random), place(random), heading(random));
  world.addPrey(place(random), place(random));
  const Row wall = world.addWall({size(random), 0.03, 0.3}, {place(random), place(random)});
  world.pose(wall).orientation = Eigen::AngleAxisd(heading(random), Eigen::Vector3d::UnitZ());
}

/// Expects the readings that single rays of the sensors give. @return number of rays that hit something
int compareWithRays(const DeviceWorld& world, Row robot, const FootbotProximity& readings) {
  const Pose& pose = world.space.entities.pose[robot];
  int felt = 0;
  for (std::size_t k = 0; k < FootbotProximity::kCount; ++k) {
    const Mount& mount = world.space.entities.model[robot]->mount("proximity_" + std::to_string(k));
    const Eigen::Vector3d from = pose.toWorld(mount.position);
    const Eigen::Vector3d ahead = pose.orientation * (mount.orientation * Eigen::Vector3d::UnitX());
    const RayHit hit = world.space.castRay({from, from + kRange * ahead}, robot);
    EXPECT_NEAR(readings.value[k], response(kRange * hit.fraction), 1e-6) << "sensor " << k;
    felt += hit.isHit() ? 1 : 0;
  }
  return felt;
}

TEST(FootbotProximityTest, EachSensorReadsWhatItsOwnRayHitsAmongMoreThanAListOfObstaclesHolds) {
  DeviceWorld world;
  const Row robot = world.addFootbot(5.0, 5.0, 0.37);
  constexpr int kPoles = 19;
  static_assert(kPoles > static_cast<int>(Obstacles::kMostOfAKind));
  for (int i = 0; i < kPoles; ++i) {
    const double angle = 2.0 * M_PI * i / kPoles;
    world.addPrey(5.0 + 0.13 * std::cos(angle), 5.0 + 0.13 * std::sin(angle), colors::kYellow, 0.01);
  }
  EXPECT_GT(compareWithRays(world, robot, Ring(world, robot).sense()), 8);
}

TEST(FootbotProximityTest, EachSensorReadsWhatItsOwnRayHitsWhateverStandsAround) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> heading(-M_PI, M_PI);
  std::uniform_real_distribution<double> tilt(0.0, 0.4);
  int felt = 0;
  for (int i = 0; i < 300; ++i) {
    DeviceWorld world;
    const Row robot = world.addFootbot(5.0, 5.0, heading(random));
    standAround(world, random);
    if (i % 4 == 3) {
      world.pose(robot).orientation =
          world.pose(robot).orientation * Eigen::AngleAxisd(tilt(random), Eigen::Vector3d(0.6, 0.8, 0.0));
    }
    SCOPED_TRACE(i);
    felt += compareWithRays(world, robot, Ring(world, robot).sense());
  }
  EXPECT_GT(felt, 300);
}

TEST(FootbotProximityTest, OnlyTheSensorThatFacesAPoleSeesIt) {
  for (const double heading : headings) {
    DeviceWorld world;
    const Row robot = world.addFootbot(1.0, 1.0, heading);
    const Row pole = world.addPrey(5.0, 5.0, colors::kBlack, 0.01);
    Ring ring(world, robot);
    for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
      const double angle = heading + FootbotProximity::angle(i);
      const double distance = kFootbotRadius + 0.05 + 0.01;
      world.pose(pole).position = {1.0 + distance * std::cos(angle), 1.0 + distance * std::sin(angle), 0.0};
      const FootbotProximity& readings = ring.sense();
      for (std::size_t k = 0; k < FootbotProximity::kCount; ++k) {
        EXPECT_NEAR(readings.value[k], k == i ? 0.125 : 0.0, 1e-6) << "pole at " << i << ", sensor " << k;
      }
    }
  }
}

TEST(FootbotProximityTest, SensorsAreEvery15DegreesCounterClockwise) {
  EXPECT_EQ(FootbotProximity::angle(0), 0.0);
  EXPECT_NEAR(FootbotProximity::angle(6), M_PI / 2.0, 1e-15);
  EXPECT_NEAR(FootbotProximity::angle(12), M_PI, 1e-15);
  EXPECT_NEAR(FootbotProximity::angle(18), -M_PI / 2.0, 1e-15);
  EXPECT_NEAR(FootbotProximity::angle(23), -M_PI / 12.0, 1e-15);
}

TEST(FootbotProximityTest, ItsOwnGripperAndWheelsAreNotSeen) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  world.addPrey(1.0 - kFootbotRadius - 0.05 - 0.01, 1.0, colors::kBlack, 0.01);  // so that the sensor casts any rays
  const FootbotProximity& readings = Ring(world, robot).sense();
  EXPECT_NEAR(readings.value[12], 0.125, 1e-6);
  for (std::size_t i = 0; i < FootbotProximity::kCount; ++i) {
    EXPECT_EQ(readings.value[i] > 0.0F, i == 12) << "sensor " << i;
  }
}

TEST(FootbotProximityTest, AnotherFootbotIsSeenAtItsHull) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0, -M_PI / 2.0);
  world.addFootbot(1.0 + 2.0 * kFootbotRadius + 0.02, 1.0, -M_PI / 2.0);  // left of the first, 2 cm apart
  EXPECT_NEAR(Ring(world, robot).sense().value[6], response(0.02), 1e-6);
}

TEST(FootbotProximityTest, WhatIsLowerOrHigherThanTheRingIsNotSeen) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  const double face = 1.0 + kFootbotRadius + 0.05;
  world.add(blockModel({0.1, 1.0, 0.05}), {face + 0.05, 1.0, 0.025});  // up to 5 cm
  world.add(blockModel({0.1, 1.0, 0.05}), {face + 0.05, 1.0, 0.095});  // from 7 cm
  Ring ring(world, robot);
  EXPECT_EQ(ring.sense().value, (std::array<float, FootbotProximity::kCount>{}));
  world.add(blockModel({0.1, 1.0, 0.02}), {face + 0.05, 1.0, 0.06});
  EXPECT_NEAR(ring.sense().value[0], 0.125, 1e-6);
}

TEST(FootbotProximityTest, ReadsNothingAgainWhenTheObstacleIsGone) {
  DeviceWorld world;
  const Row robot = world.addFootbot(1.0, 1.0);
  const Row prey = world.addPrey(1.0, 1.0 + kFootbotRadius + 0.06 + 0.03);
  Ring ring(world, robot);
  EXPECT_GT(ring.sense().value[6], 0.3F);
  world.remove(prey);
  EXPECT_EQ(ring.sense().value, (std::array<float, FootbotProximity::kCount>{}));
}

/// Returns the readings of one robot over some ticks.
std::vector<std::array<float, FootbotProximity::kCount>> over(int ticks, const std::string& noise, std::uint64_t seed,
                                                              int bystanders = 0) {
  DeviceWorld world(seed);
  const Row robot = world.addFootbot(1.0, 1.0);
  world.addWall({0.1, 2.0, 0.5}, {1.0 + kFootbotRadius + 0.05 + 0.05, 1.0});
  Ring ring(world, robot, {{"noise", noise}});
  for (int i = 0; i < bystanders; ++i) {
    ring.sensor->add(world.space, world.addFootbot(3.0 + i, 5.0));
  }
  std::vector<std::array<float, FootbotProximity::kCount>> readings;
  for (int i = 0; i < ticks; ++i) {
    readings.push_back(ring.sense().value);
    ++world.space.tick;
  }
  return readings;
}

TEST(FootbotProximityTest, NoiseIsUniformWithinItsWidthAndReadingsStayBetween0And1) {
  std::vector<double> seeing;
  std::vector<double> clear;
  for (const auto& readings : over(4000, "0.05", 1)) {
    seeing.push_back(readings[0]);
    clear.push_back(readings[12]);
    EXPECT_NEAR(readings[0], 0.125, 0.05 + 1e-6);
    EXPECT_GE(readings[12], 0.0F);
    EXPECT_LE(readings[12], 0.05F);
  }
  const Statistics of_seeing(seeing);
  EXPECT_NEAR(of_seeing.mean, 0.125, 5.0 * 0.0289 / std::sqrt(4000.0));
  EXPECT_NEAR(of_seeing.deviation, 0.05 / std::sqrt(3.0), 0.001);
  EXPECT_NEAR(Statistics(clear).mean, 0.05 / 4.0, 0.002);  // the lower half is clipped to 0
}

TEST(FootbotProximityTest, NoiseBelongsToTheSeedAndNotToWhoElseSenses) {
  EXPECT_EQ(over(50, "0.05", 1), over(50, "0.05", 1, 5));
  EXPECT_NE(over(50, "0.05", 1), over(50, "0.05", 2));
  const auto exact = over(50, "0", 1);
  EXPECT_EQ(exact, over(50, "0", 2));
  EXPECT_EQ(exact.front(), exact.back());
}

}  // namespace
}  // namespace swarmanoid::test
