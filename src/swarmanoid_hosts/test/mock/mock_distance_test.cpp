// Distance sensors of mock robots: they measure the walls of the world by the laws of the devices.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mock_bench.hpp"
#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_interface/devices/eyebot_distance.hpp"
#include "swarmanoid_interface/devices/footbot_scanner.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"
#include "swarmanoid_interface/devices/lidar.hpp"

namespace swarmanoid::mock {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

/// A wall across the x axis.
World worldWithWallAt(double x) {
  World world;
  world.walls.push_back({{x, -5.0}, {x, 5.0}});
  return world;
}

TEST(MockDistance, OfAnyRobotFromTheRingOfTheWorld) {
  World world = worldWithWallAt(0.5);
  world.ring = {8, 0.07};
  Bench bench(std::vector<std::string>{Distance::kType}, world);
  const Distance& distance = bench.reading<Distance>();
  ASSERT_EQ(8U, distance.sensors.size());
  EXPECT_NEAR(0.43, distance.sensors[0].distance, 1e-6);
  EXPECT_NEAR(0.5 * std::sqrt(2.0) - 0.07, distance.sensors[1].distance, 1e-6);
  EXPECT_NEAR(M_PI / 4.0, distance.sensors[1].angle, 1e-6);
  EXPECT_EQ(kNothing, distance.sensors[4].distance);
  bench.robot->place({{0.35, 0.0, 0.0}, 0.0});
  EXPECT_EQ(-kNothing, distance.sensors[0].distance) << "0.08 m";
}

TEST(MockDistance, OfLidars) {
  Bench bench(std::vector<std::string>{Lidar::kType}, worldWithWallAt(1.5));
  bench.robot->place({{0.0, 1.0, 0.0}, 0.2});
  const Lidar& lidar = bench.reading<Lidar>();
  ASSERT_EQ(360U, lidar.beams.size());
  EXPECT_NEAR(-1.0, lidar.beams[123].angle, 0.01) << "-180 + 123 degrees";
  EXPECT_NEAR(1.5 / std::cos(0.2 - 57.0 * M_PI / 180.0), lidar.beams[123].range, 1e-6);
  EXPECT_NEAR(1.5 / std::cos(0.2 + 40.0 * M_PI / 180.0), lidar.beams[220].range, 1e-6);
  EXPECT_EQ(kNothing, lidar.beams[0].range) << "looks back";
  EXPECT_EQ(kNothing, lidar.beams[240].range) << "4.03 m";
  bench.robot->place({{1.4, 1.0, 0.0}, 0.0});
  EXPECT_EQ(-kNothing, lidar.beams[180].range) << "0.1 m";
}

TEST(MockDistance, OfHandbots) {
  Bench bench(std::vector<std::string>{HandbotDistance::kType}, worldWithWallAt(0.36));
  bench.robot->place({{0.0, 1.0, 0.0}, 0.2});
  const HandbotDistance& distance = bench.reading<HandbotDistance>();
  EXPECT_NEAR(0.36 / std::cos(0.2) - 0.145, distance.distance[0], 1e-6);
  EXPECT_NEAR(0.36 / std::cos(0.2 - M_PI / 6.0) - 0.145, distance.distance[11], 1e-6);
  EXPECT_EQ(kNothing, distance.distance[1]) << "0.335 m";
}

TEST(MockDistance, OfEyebots) {
  World world = worldWithWallAt(1.3);
  world.ceiling = 2.4;
  Bench bench(std::vector<std::string>{EyebotDistance::kType}, world);
  bench.robot->place({{0.0, 0.0, 1.1}, -0.3});
  const EyebotDistance& distance = bench.reading<EyebotDistance>();
  EXPECT_NEAR(1.3 / std::cos(0.3) - 0.25, distance.around[0], 1e-6);
  EXPECT_EQ(kNothing, distance.around[8]);
  EXPECT_NEAR(2.4 - 1.1 - 0.36, distance.up, 1e-6);
  EXPECT_NEAR(1.25, distance.down, 1e-6);
  bench.robot->place({{0.0, 0.0, 0.0}, 0.0});
  EXPECT_EQ(-kNothing, distance.down);
  EXPECT_EQ(kNothing, distance.up);
}

TEST(MockScanner, TurnsAndMeasuresWalls) {
  Bench bench(std::vector<std::string>{FootbotScanner::kType, FootbotScannerReadings::kType}, worldWithWallAt(0.25));
  bench.robot->place({{0.0, 0.0, 0.0}, 0.1});
  const FootbotScannerReadings& readings = bench.reading<FootbotScannerReadings>();
  EXPECT_TRUE(std::isnan(readings.long_left[0]));
  bench.command<FootbotScanner>().turnAt(-1.3);
  bench.advance(2 * kStep);
  EXPECT_NEAR(-2.6 * kStep, readings.angle, 1e-9);
  EXPECT_FLOAT_EQ(0.02F, readings.period);
  for (std::size_t i = 0; i < FootbotScannerReadings::kSamples; ++i) {
    const double head = -1.3 * kStep * (1.0 + (static_cast<double>(i) + 1.0) / 8.0);
    EXPECT_NEAR(head, readings.angles[i], 1e-6) << i;
    EXPECT_NEAR(0.25 / std::cos(0.1 + head), readings.short_ahead[i], 1e-6) << i;
    EXPECT_EQ(kNothing, readings.short_behind[i]);
  }
  bench.command<FootbotScanner>().holdAngle(M_PI / 2.0);
  bench.advance(0.5);
  EXPECT_NEAR(0.25 / std::cos(0.1), readings.long_right[7], 1e-6);
  EXPECT_NEAR(M_PI / 2.0, readings.angle, 1e-9);
  bench.robot->place({{0.1, 0.0, 0.0}, 0.1});
  EXPECT_EQ(-kNothing, readings.long_right[7]);
  bench.command<FootbotScanner>().switchOff();
  bench.advance(kStep);
  EXPECT_TRUE(std::isnan(readings.long_right[7]));
  EXPECT_NEAR(M_PI / 2.0, readings.angle, 1e-9) << "stands where it was";
  bench.command<FootbotScanner>().turnAt(0.5);
  bench.advance(kStep);
  EXPECT_NEAR(M_PI / 2.0 + 0.01, readings.angle, 1e-9);
}

}  // namespace
}  // namespace swarmanoid::mock
