// The eyebot's camera looks down: its field of view is a circle on the ground that grows with its height.
#include <gtest/gtest.h>

#include <cmath>

#include "device_world.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"

namespace swarmanoid::test {
namespace {

using Camera = SensorUnderTest<EyebotCamera>;

constexpr double kAperture = M_PI / 6.0;
const Parameters kThirtyDegrees{{"aperture", "30"}};

class EyebotCameraTest : public testing::Test {
 protected:
  std::vector<ColorBlob> seen(const Parameters& parameters = kThirtyDegrees) {
    Camera camera(world, robot, parameters);
    const Span<const ColorBlob> blobs = camera.sense().blobs;
    std::vector<ColorBlob> result(blobs.begin(), blobs.end());
    camera.sensor->remove(world.space, robot);
    return result;
  }

  DeviceWorld world;
  Row robot = world.addEyebot(5.0, 5.0, 2.0);  // the camera is at 2.15 m, the centre of a prey at 0.05 m
};

TEST_F(EyebotCameraTest, SeesWhatIsInTheConeBelow) {
  const double edge = 2.1 * std::tan(kAperture);
  const Row prey = world.addPrey(5.0 + edge - 1e-9, 5.0);
  const auto blobs = seen();
  ASSERT_EQ(blobs.size(), 1U);
  EXPECT_NEAR(blobs[0].distance, edge, 1e-6);
  EXPECT_NEAR(blobs[0].bearing, 0.0, 1e-6);
  world.pose(prey).position.x() = 5.0 + edge + 1e-9;
  EXPECT_TRUE(seen().empty());
}

TEST_F(EyebotCameraTest, TheCircleOnTheGroundGrowsWithTheHeight) {
  world.addPrey(6.3, 5.0);
  EXPECT_TRUE(seen().empty());  // 2.1 m * tan 30 degrees is 1.21 m
  world.pose(robot).position.z() = 2.3;
  EXPECT_EQ(seen().size(), 1U);  // 1.39 m
}

TEST_F(EyebotCameraTest, TheRangeLimitsTheConeHorizontally) {
  world.addPrey(5.5, 5.0);
  EXPECT_EQ(seen({{"aperture", "30"}, {"range", "0.5"}}).size(), 1U);
  EXPECT_EQ(seen({{"aperture", "30"}, {"range", "0.499"}}).size(), 0U);
}

TEST_F(EyebotCameraTest, NothingAboveItIsSeenHoweverNear) {
  world.add(lightModel(), {5.0, 5.0, 2.9}, 0.0, colors::kWhite);
  EXPECT_TRUE(seen().empty());
  world.add(lightModel(), {5.0, 5.0, 1.0}, 0.0, colors::kWhite);
  EXPECT_EQ(seen().size(), 1U);
}

TEST_F(EyebotCameraTest, ALampIsSeenInItsColourHoweverDimUnlessItIsDark) {
  const Row lamp = world.add(lightModel(), {5.0, 5.0, 1.0}, 0.0, colors::kOrange);
  world.space.properties[lamp][0] = 0.001;
  ASSERT_EQ(seen().size(), 1U);
  EXPECT_EQ(seen()[0].color, colors::kOrange);
  world.space.properties[lamp][0] = 0.0;
  EXPECT_TRUE(seen().empty());
}

TEST_F(EyebotCameraTest, BearingIsFromItsOwnHeading) {
  world.addPrey(5.0, 4.5);
  world.pose(robot).orientation = Eigen::AngleAxisd(M_PI / 2.0, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(seen().at(0).bearing, static_cast<float>(M_PI));
}

TEST_F(EyebotCameraTest, ATableHidesThePreyUnderIt) {
  world.addPrey(5.0, 5.0);
  world.add(blockModel({1.0, 1.0, 0.05}), {5.0, 5.0, 0.8});
  EXPECT_TRUE(seen().empty());
}

TEST_F(EyebotCameraTest, ItsOwnLedsAreNotSeenButThoseOfFootbotsAre) {
  world.space.leds[robot][3] = colors::kRed;
  const Row footbot = world.addFootbot(5.2, 5.0);
  world.space.leds[footbot][3] = colors::kBlue;  // to the left
  const auto blobs = seen();
  ASSERT_EQ(blobs.size(), 1U);
  EXPECT_EQ(blobs[0].color, colors::kBlue);
  EXPECT_NEAR(blobs[0].distance, std::hypot(0.2, 0.085), 1e-6);
  EXPECT_NEAR(blobs[0].bearing, std::atan2(0.085, 0.2), 1e-6);
}

TEST_F(EyebotCameraTest, APatchWhoseMiddleIsOutOfViewIsSeenAtItsNearestPoint) {
  FloorPatch nest;
  nest.position = {6.5, 5.0, 0.0};
  nest.radius = 0.5;
  nest.color = colors::kGreen;
  world.space.floor.patches.push_back(nest);
  const auto blobs = seen();  // 2.15 m * tan 30 degrees is 1.24 m
  ASSERT_EQ(blobs.size(), 1U);
  EXPECT_NEAR(blobs[0].distance, 1.0, 1e-6);
  world.space.floor.patches[0].position.x() = 6.0;
  EXPECT_NEAR(seen().at(0).distance, 1.0, 1e-6) << "in view, the middle stands for the patch";
  world.space.floor.patches[0].position.x() = 7.0;
  EXPECT_TRUE(seen().empty());
  EXPECT_TRUE(seen({{"aperture", "80"}, {"sees_floor", "false"}}).empty());
}

}  // namespace
}  // namespace swarmanoid::test
