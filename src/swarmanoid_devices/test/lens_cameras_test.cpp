// Cameras with a lens: those of footbots and handbots look ahead, one of eyebots pans and tilts. 60 x 45 degrees.
#include <gtest/gtest.h>

#include <cmath>

#include "device_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_pan_tilt.hpp"

namespace swarmanoid::test {
namespace {

using Eigen::Vector3d;

/// A camera and one lamp.
template <class Device>
class OneLamp {
 public:
  OneLamp(const std::string& robot, const Vector3d& place, const Parameters& parameters = {})
      : robot_(world.add(robotModel(robot), place, 0.83)),
        lamp_(world.add(lightModel(), place, 0.0, colors::kRed)),
        camera_(world, robot_, parameters) {}

  /// Places the lamp in the robot's frame. @return whether the camera sees it
  bool sees(const Vector3d& lamp) {
    world.pose(lamp_).position = world.pose(robot_).toWorld(lamp);
    const auto& blobs = camera_.sense().blobs;
    if (!blobs.empty()) {
      blob = blobs[0];
    }
    return !blobs.empty();
  }
  /// The same, relative to the camera's direction: to the left and up by angles in the picture [rad].
  bool seesInPicture(const Vector3d& mount, double left, double up) {
    return sees(mount + Vector3d(1.0, std::tan(left), std::tan(up)));
  }
  Row robot() const { return robot_; }

  DeviceWorld world;
  ColorBlob blob;

 private:
  Row robot_;
  Row lamp_;
  SensorUnderTest<Device> camera_;
};

const Vector3d kFootbotMount(0.08, 0.0, 0.09);

TEST(FootbotFrontCameraTest, SeesAPyramidAhead) {
  OneLamp<FootbotFrontCamera> test("footbot", {5.0, 5.0, 0.0});
  EXPECT_TRUE(test.seesInPicture(kFootbotMount, 0.0, 0.0));
  EXPECT_TRUE(test.seesInPicture(kFootbotMount, 29.9 * kDegree, 0.0));
  EXPECT_FALSE(test.seesInPicture(kFootbotMount, 30.1 * kDegree, 0.0));
  EXPECT_TRUE(test.seesInPicture(kFootbotMount, -29.9 * kDegree, 22.4 * kDegree)) << "a corner";
  EXPECT_FALSE(test.seesInPicture(kFootbotMount, -29.9 * kDegree, 22.6 * kDegree));
  EXPECT_TRUE(test.sees(kFootbotMount + Vector3d(0.2, 0.0, -0.08)));
  EXPECT_FALSE(test.sees(kFootbotMount + Vector3d(-0.5, 0.0, 0.0))) << "behind";
  EXPECT_FALSE(test.sees(kFootbotMount + Vector3d(0.0, 0.0, 0.0))) << "in the lens";
}

TEST(FootbotFrontCameraTest, KnowsDirectionsAndNoDistance) {
  OneLamp<FootbotFrontCamera> test("footbot", {5.0, 5.0, 0.0});
  ASSERT_TRUE(test.sees(kFootbotMount + Vector3d(0.9, -0.37, 0.21)));
  EXPECT_NEAR(test.blob.bearing, std::atan2(-0.37, 0.9), 1e-6);
  EXPECT_NEAR(test.blob.elevation, std::atan2(0.21, std::hypot(0.9, 0.37)), 1e-6);
  EXPECT_NEAR(test.blob.size, 2.0 * std::atan(0.005 / std::hypot(0.9, 0.37, 0.21)), 1e-8);
  EXPECT_TRUE(std::isnan(test.blob.distance));
}

TEST(FootbotFrontCameraTest, TheAnglesOfViewAndTheRangeAreParameters) {
  OneLamp<FootbotFrontCamera> test("footbot", {5.0, 5.0, 0.0},
                                   {{"view_width", "21"}, {"view_height", "90"}, {"range", "1.3"}});
  EXPECT_TRUE(test.seesInPicture(kFootbotMount, 10.4 * kDegree, 44.9 * kDegree));
  EXPECT_FALSE(test.seesInPicture(kFootbotMount, 10.6 * kDegree, 0.0));
  EXPECT_TRUE(test.sees(kFootbotMount + Vector3d(1.299, 0.0, 1.0)));
  EXPECT_FALSE(test.sees(kFootbotMount + Vector3d(1.301, 0.0, 1.0)));
}

TEST(FootbotFrontCameraTest, ARaisedNoseLooksUpAndTheHorizonStays) {
  OneLamp<FootbotFrontCamera> test("footbot", {5.0, 5.0, 0.0});
  const Vector3d lamp = kFootbotMount + Vector3d(1.0, 0.0, std::tan(30.0 * kDegree));
  EXPECT_FALSE(test.sees(lamp));
  Pose& pose = test.world.pose(test.robot());
  const Vector3d in_world = pose.toWorld(lamp);
  pose.orientation = pose.orientation * Eigen::AngleAxisd(-14.0 * kDegree, Vector3d::UnitY());
  ASSERT_TRUE(test.sees(pose.orientation.conjugate() * (in_world - pose.position)));
  const Vector3d way = in_world - pose.toWorld(kFootbotMount);
  EXPECT_NEAR(test.blob.elevation, std::atan2(way.z(), way.head<2>().norm()), 1e-6);
  EXPECT_NEAR(test.blob.bearing, 0.0, 1e-6);
}

TEST(FootbotFrontCameraTest, NoiseLeavesAnUnknownDistanceUnknown) {
  OneLamp<FootbotFrontCamera> test("footbot", {5.0, 5.0, 0.0}, {{"noise_distance", "0.1"}, {"noise_bearing", "2"}});
  ASSERT_TRUE(test.sees(kFootbotMount + Vector3d(0.9, 0.1, 0.0)));
  EXPECT_TRUE(std::isnan(test.blob.distance));
  EXPECT_NE(test.blob.bearing, static_cast<float>(std::atan2(0.1, 0.9)));
}

TEST(HandbotCameraTest, LooksAheadFromTheHead) {
  const Vector3d mount(0.105, 0.0, 0.16);
  OneLamp<HandbotCamera> test("handbot", {5.0, 5.0, 0.0});
  EXPECT_TRUE(test.seesInPicture(mount, 29.9 * kDegree, -8.0 * kDegree));
  EXPECT_FALSE(test.seesInPicture(mount, 30.1 * kDegree, -8.0 * kDegree));
  EXPECT_FALSE(test.sees(mount + Vector3d(-0.7, 0.0, 0.0)));
  EXPECT_TRUE(std::isnan(test.blob.distance));
}

const Vector3d kEyebotMount(0.085, 0.0, 0.17);

/// Advances a tick and actuates.
const EyebotPanTilt& next(DeviceWorld& world, ActuatorUnderTest<EyebotPanTilt>& mounting) {
  ++world.space.tick;
  return mounting.actuate();
}

TEST(EyebotPanTiltTest, TurnsAsFastAsItCanAndNoFartherThanItsStops) {
  DeviceWorld world;
  ActuatorUnderTest<EyebotPanTilt> mounting(world, world.addEyebot(5.0, 5.0, 1.0));
  mounting.command = {0.5, -0.4};
  EXPECT_NEAR(next(world, mounting).pan, 0.2, 1e-12) << "2 rad/s for 0.1 s";
  EXPECT_NEAR(next(world, mounting).tilt, -0.3, 1e-12) << "1.5 rad/s for 0.2 s";
  EXPECT_NEAR(next(world, mounting).pan, 0.5, 1e-12) << "there";
  EXPECT_NEAR(next(world, mounting).tilt, -0.4, 1e-12);
  EXPECT_EQ(mounting.command.pan, 0.5) << "the command stays";
  mounting.command = {-9.0, -9.0};
  for (int tick = 0; tick < 40; ++tick) {
    next(world, mounting);
  }
  EXPECT_EQ(next(world, mounting).pan, -2.6);
  EXPECT_EQ(next(world, mounting).tilt, -1.57);
  EXPECT_TRUE(mounting.stop());
  EXPECT_EQ(next(world, mounting).pan, -2.6) << "it goes on looking there";
}

TEST(EyebotPanTiltTest, ItsSpeedsAreParameters) {
  DeviceWorld world;
  ActuatorUnderTest<EyebotPanTilt> mounting(world, world.addEyebot(5.0, 5.0, 1.0),
                                            {{"pan_speed", "0.7"}, {"tilt_speed", "30"}});
  mounting.command = {-1.0, 0.3};
  EXPECT_NEAR(next(world, mounting).pan, -0.07, 1e-12);
  EXPECT_EQ(next(world, mounting).tilt, 0.3);
}

TEST(EyebotPanTiltTest, ASafeStopTurnsItNoFaster) {
  DeviceWorld world;
  ActuatorUnderTest<EyebotPanTilt> mounting(world, world.addEyebot(5.0, 5.0, 1.0), {}, {bias("pan", "0.05")});
  mounting.command = {1.0, 0.0};
  EXPECT_NEAR(next(world, mounting).pan, 0.2, 1e-12) << "2 rad/s for 0.1 s";
  mounting.stop();
  EXPECT_NEAR(world.space.actuation.find<EyebotPanTilt>(Row{0})->pan, 0.2, 1e-12) << "still the same tick";
}

TEST(EyebotPanTiltCameraTest, LooksAheadWithoutItsActuator) {
  OneLamp<EyebotPanTiltCamera> test("eyebot", {5.0, 5.0, 1.0});
  EXPECT_TRUE(test.seesInPicture(kEyebotMount, 29.9 * kDegree, 0.0));
  EXPECT_FALSE(test.seesInPicture(kEyebotMount, 30.1 * kDegree, 0.0));
}

TEST(EyebotPanTiltCameraTest, LooksWhereItsMountingStands) {
  OneLamp<EyebotPanTiltCamera> test("eyebot", {5.0, 5.0, 1.0});
  ActuatorUnderTest<EyebotPanTilt> mounting(test.world, test.robot(), {{"pan_speed", "99"}, {"tilt_speed", "99"}});
  mounting.command = {1.2, -0.6};
  mounting.actuate();
  const auto lampAt = [](double bearing, double elevation) -> Vector3d {
    return kEyebotMount + Vector3d(std::cos(bearing), std::sin(bearing), std::tan(elevation));
  };
  ASSERT_TRUE(test.sees(lampAt(1.2, -0.6)));
  EXPECT_NEAR(test.blob.bearing, 1.2, 1e-6) << "in the robot's frame, not in the picture's";
  EXPECT_NEAR(test.blob.elevation, -0.6, 1e-6);
  EXPECT_TRUE(test.sees(lampAt(1.2, -0.6 + 22.4 * kDegree))) << "the upper edge";
  EXPECT_FALSE(test.sees(lampAt(1.2, -0.6 + 22.6 * kDegree)));
  EXPECT_TRUE(test.sees(lampAt(1.2, -0.6 - 22.4 * kDegree)));
  EXPECT_FALSE(test.sees(lampAt(1.2, -0.6 - 22.6 * kDegree)));
  EXPECT_FALSE(test.sees(lampAt(0.0, 0.0)));
  mounting.command = {0.0, -1.57};
  mounting.actuate();
  ASSERT_TRUE(test.sees(kEyebotMount + Vector3d(0.21, -0.2, -0.8))) << "straight down";
  EXPECT_NEAR(test.blob.bearing, std::atan2(-0.2, 0.21), 1e-6);
  EXPECT_FALSE(test.sees(kEyebotMount + Vector3d(0.0, 0.0, 0.8)));
}

}  // namespace
}  // namespace swarmanoid::test
