// The eyebot's omnidirectional camera, 0.42 m above its origin; and the fields of blobs, which all cameras share.
#include <gtest/gtest.h>

#include <cmath>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::test {
namespace {

using OmnidirectionalCamera = SensorUnderTest<EyebotOmnidirectionalCamera>;

TEST(EyebotOmnidirectionalCameraTest, SeesTheLedsOfEyebotsAtAnyHeight) {
  for (const double height : {0.0, 0.9, 1.2, 2.35}) {
    DeviceWorld world;
    const Row watcher = world.addEyebot(5.0, 5.0, 1.0, 0.3);
    const Row other = world.addEyebot(6.2, 5.9, height, 0.7);
    world.space.leds[other][3] = colors::kRed;
    OmnidirectionalCamera camera(world, watcher);
    const auto& blobs = camera.sense().blobs;
    ASSERT_EQ(blobs.size(), 1U) << height << " m";
    // LED 3 of 16 is at 67.5 degrees on a ring of 0.1 m, 0.2 m above the robot's origin; the camera is at 1.42 m
    const double azimuth = 67.5 * M_PI / 180.0 + 0.7;
    const double x = 1.2 + 0.1 * std::cos(azimuth);
    const double y = 0.9 + 0.1 * std::sin(azimuth);
    const double z = height + 0.2 - 1.42;
    EXPECT_NEAR(blobs[0].bearing, std::atan2(y, x) - 0.3, 1e-6);
    EXPECT_NEAR(blobs[0].distance, std::hypot(x, y), 1e-6);
    EXPECT_NEAR(blobs[0].elevation, std::atan2(z, std::hypot(x, y)), 1e-6);
    EXPECT_NEAR(blobs[0].size, 2.0 * std::atan(0.005 / std::hypot(x, y, z)), 1e-8) << "a LED is 1 cm across";
  }
}

TEST(EyebotOmnidirectionalCameraTest, SeesLampsByTheirColourAboveAndBelow) {
  DeviceWorld world;
  const Row watcher = world.addEyebot(5.0, 5.0, 1.0);
  world.add(lightModel(), {5.0, 5.6, 2.9}, 0.0, colors::kOrange);
  world.add(lightModel(), {4.4, 5.0, 0.1}, 0.0, colors::kCyan);
  world.add(lightModel(0.0), {5.6, 5.0, 0.1}, 0.0, colors::kWhite);  // dark
  OmnidirectionalCamera camera(world, watcher);
  const auto& blobs = camera.sense().blobs;
  ASSERT_EQ(blobs.size(), 2U);
  EXPECT_EQ(blobs[0].color, colors::kOrange);
  EXPECT_NEAR(blobs[0].elevation, std::atan2(1.48, 0.6), 1e-6);
  EXPECT_NEAR(blobs[0].bearing, M_PI / 2.0, 1e-6);
  EXPECT_EQ(blobs[1].color, colors::kCyan);
  EXPECT_NEAR(blobs[1].elevation, std::atan2(-1.32, 0.6), 1e-6);
}

TEST(EyebotOmnidirectionalCameraTest, WhatStandsBetweenHidesAndTheRangeIsHorizontal) {
  DeviceWorld world;
  const Row watcher = world.addEyebot(5.0, 5.0, 1.0);
  world.add(lightModel(), {6.1, 5.0, 2.9}, 0.0, colors::kOrange);
  EXPECT_EQ(OmnidirectionalCamera(world, watcher, {{"range", "1.11"}}).sense().blobs.size(), 1U);
  DeviceWorld another;
  const Row same = another.addEyebot(5.0, 5.0, 1.0);
  another.add(lightModel(), {6.1, 5.0, 2.9}, 0.0, colors::kOrange);
  EXPECT_EQ(OmnidirectionalCamera(another, same, {{"range", "1.09"}}).sense().blobs.size(), 0U);
  // a board half way, at 2.16 m
  DeviceWorld third;
  const Row below = third.addEyebot(5.0, 5.0, 1.0);
  third.add(lightModel(), {6.1, 5.0, 2.9}, 0.0, colors::kOrange);
  third.add(blockModel({0.3, 0.3, 0.02}), {5.55, 5.0, 2.16});
  EXPECT_EQ(OmnidirectionalCamera(third, below).sense().blobs.size(), 0U);
}

TEST(ColorBlobTest, PreysAndPatchesAreAsLargeAsTheyAre) {
  DeviceWorld world;
  const Row watcher = world.addFootbot(4.0, 4.0);
  world.addPrey(4.9, 4.0, colors::kYellow, 0.07, 0.1);
  FloorPatch disc;
  disc.position = {4.0, 3.2, 0.0};
  disc.radius = 0.3;
  disc.color = colors::kGreen;
  FloorPatch rectangle;
  rectangle.position = {3.4, 4.0, 0.0};
  rectangle.size = {0.1, 0.5};
  rectangle.color = colors::kBlue;
  world.space.floor.patches = {disc, rectangle};
  SensorUnderTest<FootbotCamera> camera(world, watcher, {{"sees_floor", "true"}});
  const auto& blobs = camera.sense().blobs;
  ASSERT_EQ(blobs.size(), 3U);
  EXPECT_NEAR(blobs[0].size, 2.0 * std::atan(0.07 / std::hypot(0.9, 0.23)), 1e-6);
  EXPECT_NEAR(blobs[0].elevation, std::atan2(-0.23, 0.9), 1e-6)
      << "the prey's middle is at 0.05 m, the camera at 0.28 m";
  EXPECT_NEAR(blobs[1].size, 2.0 * std::atan(0.3 / std::hypot(0.8, 0.28)), 1e-6);
  EXPECT_NEAR(blobs[2].size, 2.0 * std::atan(0.25 / std::hypot(0.6, 0.28)), 1e-6) << "by its longer side";
}

}  // namespace
}  // namespace swarmanoid::test
