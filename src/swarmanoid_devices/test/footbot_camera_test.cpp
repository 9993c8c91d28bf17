// The omnidirectional camera, 0.28 m above the ground on the robot's axis.
#include <gtest/gtest.h>

#include <cmath>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::test {
namespace {

using Camera = SensorUnderTest<FootbotCamera>;

/// A footbot at (1, 1), and the readings of its camera.
class FootbotCameraTest : public testing::Test {
 protected:
  std::vector<ColorBlob> seen(const Parameters& parameters = {}) {
    Camera camera(world, robot, parameters);
    const Span<const ColorBlob> blobs = camera.sense().blobs;
    std::vector<ColorBlob> result(blobs.begin(), blobs.end());
    camera.sensor->remove(world.space, robot);
    return result;
  }

  DeviceWorld world;
  Row robot = world.addFootbot(1.0, 1.0);
};

TEST_F(FootbotCameraTest, SaysColourDistanceAndBearing) {
  world.addPrey(1.6, 1.8, colors::kMagenta);
  const auto blobs = seen();
  ASSERT_EQ(blobs.size(), 1U);
  EXPECT_EQ(blobs[0].color, colors::kMagenta);
  EXPECT_FLOAT_EQ(blobs[0].distance, 1.0F);
  EXPECT_FLOAT_EQ(blobs[0].bearing, static_cast<float>(std::atan2(0.8, 0.6)));
}

TEST_F(FootbotCameraTest, BearingIsFromTheRobotsOwnHeading) {
  world.addPrey(1.0, 2.0);
  for (const auto& [heading, bearing] :
       {std::pair(0.0, M_PI / 2.0), std::pair(M_PI / 2.0, 0.0), std::pair(2.0, M_PI / 2.0 - 2.0),
        std::pair(-2.5, M_PI / 2.0 + 2.5 - 2 * M_PI)}) {
    world.pose(robot).orientation = Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ());
    EXPECT_NEAR(seen().at(0).bearing, bearing, 1e-6) << "heading " << heading;
  }
}

TEST_F(FootbotCameraTest, StraightBehindIsPlusPi) {
  // on both sides of the angle's discontinuity, and exactly at it
  const Row prey = world.addPrey(0.0, 1.0);
  for (const double y : {1.0, 1.0 + 1e-9}) {
    world.pose(prey).position.y() = y;
    EXPECT_EQ(seen().at(0).bearing, static_cast<float>(M_PI));
  }
  world.pose(prey).position = {2.0, 1.0, 0.0};
  world.pose(robot).orientation = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(seen().at(0).bearing, static_cast<float>(M_PI));
}

TEST_F(FootbotCameraTest, TheRangeIsIncludedAndNothingBeyondIt) {
  const Row prey = world.addPrey(2.0, 1.0);
  EXPECT_EQ(seen({{"range", "1"}}).size(), 1U);
  world.pose(prey).position.x() = std::nextafter(2.0, 3.0);
  EXPECT_EQ(seen({{"range", "1"}}).size(), 0U);
  world.pose(prey).position = {1.0, 3.0, 0.0};
  EXPECT_EQ(seen().size(), 1U) << "two metres are the default";
}

TEST_F(FootbotCameraTest, SeesLedsOfOthersEachWithItsColourButNotItsOwn) {
  world.space.leds[robot][0] = colors::kRed;
  const Row other = world.addFootbot(2.0, 1.0);
  world.space.leds[other][0] = colors::kRed;     // ahead, on the far side, hidden by the robot's body
  world.space.leds[other][5] = colors::kOrange;  // behind, to the left
  world.space.leds[other][6] = colors::kGreen;   // behind, on the near side
  const auto blobs = seen();
  ASSERT_EQ(blobs.size(), 2U);
  EXPECT_EQ(blobs[0].color, colors::kOrange);
  EXPECT_NEAR(blobs[0].distance, std::hypot(1.0 - 0.085 * std::cos(M_PI / 6.0), 0.085 * 0.5), 1e-6);
  EXPECT_EQ(blobs[1].color, colors::kGreen);
  EXPECT_NEAR(blobs[1].distance, 0.915, 1e-6);
}

TEST_F(FootbotCameraTest, WhatIsBlackIsNotSeen) {
  world.addPrey(1.5, 1.0, colors::kBlack);
  world.addFootbot(1.0, 1.5);
  EXPECT_TRUE(seen().empty());
}

TEST_F(FootbotCameraTest, AWallHidesWhatIsBehindItUnlessItIsLowerThanTheLineOfSight) {
  world.addPrey(2.0, 1.0);  // the line falls from 0.28 m to the prey's centre at 0.05 m
  EXPECT_EQ(seen().size(), 1U);
  const Row low = world.addWall({0.002, 1.0, 0.16}, {1.5, 1.0});  // the line is 0.165 m high there
  EXPECT_EQ(seen().size(), 1U);
  world.remove(low);
  world.addWall({0.002, 1.0, 0.17}, {1.5, 1.0});
  EXPECT_EQ(seen().size(), 0U);
}

TEST_F(FootbotCameraTest, SeesThroughAGapButNotBesideIt) {
  const Row prey = world.addPrey(2.0, 1.0);
  world.addWall({0.1, 1.0, 0.5}, {1.5, 1.51});
  world.addWall({0.1, 1.0, 0.5}, {1.5, 0.49});  // leaves a gap of 2 cm
  EXPECT_EQ(seen().size(), 1U);
  world.pose(prey).position.y() = 1.05;  // the line leaves the gap: 0.0275 m aside at x = 1.55
  EXPECT_EQ(seen().size(), 0U);
}

TEST_F(FootbotCameraTest, ARobotHidesWhatIsBehindItWhereTheLineOfSightIsLowerThanItsBody) {
  world.addPrey(2.0, 1.0);
  const Row other = world.addFootbot(1.4, 1.0);  // 0.146 m high; the line is above 0.16 m there
  EXPECT_EQ(seen().size(), 1U);
  world.pose(other).position.x() = 1.8;  // 0.096 m
  EXPECT_EQ(seen().size(), 0U);
}

TEST_F(FootbotCameraTest, APreyHidesAnotherButNotItself) {
  world.addPrey(2.0, 1.0, colors::kYellow, 0.2, 0.2);
  world.addPrey(2.5, 1.0, colors::kGreen);
  const auto blobs = seen();
  ASSERT_EQ(blobs.size(), 1U);
  EXPECT_EQ(blobs[0].color, colors::kYellow);
}

TEST_F(FootbotCameraTest, EntitiesComeByNumberThenLaserSpotsThenFloorPatches) {
  world.space.laser_spots.push_back({EntityNumber{2}, Eigen::Vector3d::Zero(), {1.5, 1.5, 0.0}, colors::kRed});
  FloorPatch nest;
  nest.position = {2.0, 2.0, 0.0};
  nest.radius = 0.1;
  nest.color = colors::kGreen;
  world.space.floor.patches.push_back(nest);
  world.addPrey(1.0, 0.5, colors::kYellow);
  world.addPrey(1.3, 1.0, colors::kMagenta);
  std::vector<Color> order;
  for (const ColorBlob& blob : seen({{"sees_floor", "true"}})) {
    order.push_back(blob.color);
  }
  EXPECT_EQ(order, (std::vector<Color>{colors::kYellow, colors::kMagenta, colors::kRed, colors::kGreen}));
  EXPECT_EQ(seen().size(), 3U) << "by default it does not see the floor";
}

TEST_F(FootbotCameraTest, AnOverflowIsMarkedReportedOnceAndCounted) {
  for (int i = 0; i < 5; ++i) {
    world.addPrey(1.0, 1.3 + 0.3 * i);
  }
  Camera camera(world, robot, {{"max_blobs", "2"}});
  for (int tick = 0; tick < 3; ++tick) {
    const FootbotCamera& readings = camera.sense();
    EXPECT_EQ(readings.blobs.size(), 2U);
    EXPECT_TRUE(readings.overflowed);
  }
  ASSERT_EQ(world.space.events.size(), 1U);
  EXPECT_EQ(world.space.events[0].kind, Event::Kind::kOverflow);
  EXPECT_EQ(world.space.events[0].text, "footbot_camera: more than 2 blobs");
  ASSERT_EQ(world.space.overflows.size(), 1U);
  EXPECT_EQ(world.space.overflows[0].robot, world.space.entities.name[robot]);
  EXPECT_EQ(world.space.overflows[0].device, "footbot_camera");
  EXPECT_EQ(world.space.overflows[0].readings, 3U);
}

TEST_F(FootbotCameraTest, ARobotThatComesBackGoesOnCounting) {
  for (int i = 0; i < 5; ++i) {
    world.addPrey(1.0, 1.3 + 0.3 * i);
  }
  for (int life = 0; life < 2; ++life) {
    Camera camera(world, robot, {{"max_blobs", "2"}});
    camera.sense();
    camera.sensor->remove(world.space, robot);
  }
  ASSERT_EQ(world.space.overflows.size(), 1U);
  EXPECT_EQ(world.space.overflows[0].readings, 2U);
}

TEST_F(FootbotCameraTest, WhatFitsIsNoOverflow) {
  world.addPrey(1.0, 1.3);
  world.addPrey(1.0, 1.6);
  Camera camera(world, robot, {{"max_blobs", "2"}});
  EXPECT_EQ(camera.sense().blobs.size(), 2U);
  EXPECT_TRUE(world.space.overflows.empty());
}

TEST(FootbotCameraNoiseTest, HasTheStatedDeviationsAndBelongsToTheSeed) {
  const auto over = [](std::uint64_t seed, const Parameters& parameters) {
    DeviceWorld world(seed);
    const Row robot = world.addFootbot(1.0, 1.0);
    world.addPrey(2.0, 1.0);
    Camera camera(world, robot, parameters);
    std::vector<double> distances;
    std::vector<double> bearings;
    for (; world.space.tick < 4000; ++world.space.tick) {
      distances.push_back(camera.sense().blobs[0].distance);
      bearings.push_back(camera.sense().blobs[0].bearing);
    }
    return std::pair(distances, bearings);
  };
  const Parameters noisy{{"noise_distance", "0.05"}, {"noise_bearing", "2"}};
  const auto [distances, bearings] = over(1, noisy);
  EXPECT_NEAR(Statistics(distances).mean, 1.0, 5.0 * 0.05 / std::sqrt(4000.0));
  EXPECT_NEAR(Statistics(distances).deviation, 0.05, 0.003);
  EXPECT_NEAR(Statistics(bearings).mean, 0.0, 5.0 * 0.0349 / std::sqrt(4000.0));
  EXPECT_NEAR(Statistics(bearings).deviation, 2.0 * M_PI / 180.0, 0.002);
  EXPECT_EQ(over(1, noisy).first, distances);
  EXPECT_NE(over(2, noisy).first, distances);
  EXPECT_EQ(over(1, {}), std::pair(std::vector<double>(4000, 1.0), std::vector<double>(4000, 0.0)));
}

}  // namespace
}  // namespace swarmanoid::test
