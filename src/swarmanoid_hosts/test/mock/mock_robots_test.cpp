// Mock robots move as commanded, and their sensors show the motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mock_bench.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_pan_tilt.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_proximity.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/devices/handbot_vacuum.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"

namespace swarmanoid::mock {
namespace {

TEST(MockFootbot, DrivesStraightAndTurnsLeft) {
  Bench bench("footbot");
  bench.command<FootbotWheels>().drive(0.1, 0.0);
  bench.advance(2.0);
  EXPECT_NEAR(0.2, bench.robot->state().pose.position.x(), 1e-9);
  bench.command<FootbotWheels>().drive(0.0, 0.5);
  bench.advance(1.0);
  EXPECT_NEAR(0.5, bench.robot->state().pose.yaw, 1e-9);
}

TEST(MockFootbot, DrivesACircleBackToItsStart) {
  Bench bench("footbot");
  bench.command<FootbotWheels>().drive(0.1, 2.0 * M_PI / 10.0);
  bench.advance(2.5);
  const double radius = 0.1 / (2.0 * M_PI / 10.0);
  EXPECT_NEAR(radius, bench.robot->state().pose.position.x(), 1e-9);
  EXPECT_NEAR(radius, bench.robot->state().pose.position.y(), 1e-9);
  bench.advance(7.5);
  EXPECT_NEAR(0.0, bench.robot->state().pose.position.norm(), 1e-9);
}

TEST(MockFootbot, FeelsAWallWhereItIs) {
  World world;
  world.walls.push_back({{-1.0, 0.135}, {1.0, 0.135}});  // on its left
  Bench bench("footbot", world);
  const FootbotProximity& proximity = bench.reading<FootbotProximity>();
  EXPECT_NEAR(0.125F, proximity.value[6], 1e-6F) << "0.05 m from its side, half the range";
  EXPECT_EQ(0.0F, proximity.value[0]);
  EXPECT_EQ(0.0F, proximity.value[18]);
  EXPECT_EQ(proximity.value[5], proximity.value[7]);
  EXPECT_LT(proximity.value[5], proximity.value[6]);
}

/// The simulator's sensor has the same law: its own test compares it with the same polynomial.
TEST(MockFootbot, ReadsDistancesByTheLawOfTheDevice) {
  for (const double distance : {0.0, 0.0137, 0.0271, 0.0613, 0.0891, 0.0999, 0.1003, 0.7}) {
    World world;
    world.walls.push_back(
        {{-1.0, FootbotProximity::kRingRadius + distance}, {1.0, FootbotProximity::kRingRadius + distance}});
    Bench bench("footbot", world);
    const double fraction = std::min(distance / 0.1, 1.0);
    EXPECT_NEAR(std::pow(1.0 - fraction, 3.0), bench.reading<FootbotProximity>().value[6], 1e-6) << distance;
    EXPECT_FLOAT_EQ(Proximity::response(fraction), bench.reading<FootbotProximity>().value[6]) << distance;
  }
}

TEST(MockFootbot, DrivesNoFasterThanItsWheels) {
  Bench bench("footbot");
  bench.command<FootbotWheels>().setAngularVelocity(1000.0, 1000.0);
  bench.advance(1.0);
  EXPECT_NEAR(0.3, bench.robot->state().pose.position.x(), 1e-9);
  EXPECT_NEAR(0.3, bench.robot->state().twist.linear.x(), 1e-12);
}

TEST(MockFootbot, SeesNothingBeyondTheRangeOfItsCamera) {
  Bench bench("footbot", worldWith({"nest", {2.05, 0.0, 0.0}, colors::kGreen, false}));
  EXPECT_TRUE(bench.reading<FootbotCamera>().blobs.empty());
  bench.command<FootbotWheels>().drive(0.1, 0.0);
  bench.advance(1.0);
  EXPECT_EQ(1U, bench.reading<FootbotCamera>().blobs.size());
}

TEST(MockFootbot, SeesABeaconMoveAsItDrives) {
  Bench bench("footbot", worldWith({"prey", {1.0, 1.0, 0.0}, colors::kYellow, false}));
  const auto& camera = bench.reading<FootbotCamera>();
  ASSERT_EQ(1U, camera.blobs.size());
  EXPECT_EQ(colors::kYellow, camera.blobs[0].color);
  EXPECT_NEAR(M_PI / 4.0, camera.blobs[0].bearing, 1e-6);
  EXPECT_NEAR(std::sqrt(2.0), camera.blobs[0].distance, 1e-6);
  bench.command<FootbotWheels>().drive(0.1, 0.0);
  bench.advance(10.0);
  EXPECT_NEAR(M_PI / 2.0, camera.blobs[0].bearing, 1e-6);
  EXPECT_NEAR(1.0, camera.blobs[0].distance, 1e-6);
}

/// The disc under each spot was computed by another program.
TEST(MockFootbot, ReadsTheFloorUnderIt) {
  Bench bench("footbot", worldWithDiscs(), {{0.13, 0.27, 0.0}, 0.83});
  const float gray = 128.0F / 255.0F;
  const float green = 1.0F / 3.0F;
  const float around[] = {1.0F, 1.0F, 1.0F, green, green, gray, gray, gray};
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(around[i], bench.reading<FootbotGround>().value[i], 1e-6) << i;
  }
  const float between[] = {1.0F, green, green, gray};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(between[i], bench.reading<FootbotBaseGround>().value[i], 1e-6) << i;
  }
}

TEST(MockFootbot, GripsWhatIsNearAndTakesItAlong) {
  Bench bench("footbot", worldWith({"prey", {0.3, 0.0, 0.05}, colors::kYellow, true}));
  bench.command<FootbotGripper>().close();
  bench.advance(0.1);
  EXPECT_FALSE(bench.reading<FootbotGripperState>().gripping) << "out of reach";
  bench.command<FootbotWheels>().drive(0.1, 0.0);
  bench.advance(2.0);
  EXPECT_TRUE(bench.reading<FootbotGripperState>().gripping);
  EXPECT_NEAR(0.31, bench.robot->state().world.beacons[0].at.x(), 1e-9) << "at its tip";
  bench.command<FootbotGripper>().open();
  bench.advance(0.5);
  EXPECT_FALSE(bench.reading<FootbotGripperState>().gripping);
  EXPECT_NEAR(0.31, bench.robot->state().world.beacons[0].at.x(), 1e-9);
}

TEST(MockFootbot, TurretFollows) {
  Bench bench("footbot");
  bench.command<FootbotTurret>().holdAngle(1.0);
  bench.advance(0.1);
  EXPECT_NEAR(0.3, bench.reading<FootbotTurretState>().angle, 1e-9) << "at 3 rad/s";
  bench.advance(1.0);
  EXPECT_NEAR(1.0, bench.reading<FootbotTurretState>().angle, 1e-9);
  bench.command<FootbotTurret>().turnAt(-0.5);
  bench.advance(2.0);
  EXPECT_NEAR(0.0, bench.reading<FootbotTurretState>().angle, 1e-9);
  EXPECT_EQ(-0.5, bench.reading<FootbotTurretState>().speed);
}

TEST(MockEyebot, FliesInItsOwnFrame) {
  Pose start;
  start.position.z() = 1.0;
  start.yaw = M_PI / 2.0;
  Bench bench("eyebot", {}, start);
  bench.command<EyebotVelocity>().linear = {0.2, 0.1, 0.3};
  bench.advance(1.0);
  EXPECT_NEAR(-0.1, bench.robot->state().pose.position.x(), 1e-9);
  EXPECT_NEAR(0.2, bench.robot->state().pose.position.y(), 1e-9);
  EXPECT_NEAR(1.3, bench.robot->state().pose.position.z(), 1e-9);
  bench.command<EyebotVelocity>().linear = {0.0, 0.0, -0.5};
  bench.advance(5.0);
  EXPECT_EQ(0.0, bench.robot->state().pose.position.z()) << "the ground";
}

TEST(MockEyebot, FliesNoFasterThanItCan) {
  Bench bench("eyebot");
  EXPECT_EQ(1.5, bench.robot->state().pose.position.z()) << "its usual altitude";
  bench.command<EyebotVelocity>().linear = {3.0, 4.0, 0.0};
  bench.command<EyebotVelocity>().yaw_rate = -50.0;
  bench.advance(kStep);
  EXPECT_NEAR(1.0, bench.robot->state().twist.linear.norm(), 1e-12);
  EXPECT_EQ(-2.0, bench.robot->state().twist.yaw_rate);
}

TEST(MockEyebot, SeesTheSpotOfItsLaser) {
  Bench bench("eyebot");
  EXPECT_TRUE(bench.reading<EyebotCamera>().blobs.empty());
  bench.command<EyebotLaser>() = {true, M_PI / 2.0, 0.5};
  bench.advance(kStep);
  ASSERT_EQ(1U, bench.reading<EyebotCamera>().blobs.size());
  const double left = 1.65 * std::tan(0.5);  // from 0.05 m ahead and 0.15 m above the robot's origin
  EXPECT_NEAR(std::hypot(0.05, left), bench.reading<EyebotCamera>().blobs[0].distance, 1e-6);
  EXPECT_NEAR(std::atan2(left, 0.05), bench.reading<EyebotCamera>().blobs[0].bearing, 1e-6);
  bench.command<EyebotLaser>().tilt = 5.0;
  bench.advance(kStep);
  EXPECT_NEAR(1.65 * std::tan(0.8), bench.robot->state().spots.begin()->second.at.y(), 1e-9) << "its limit";
  EXPECT_TRUE(bench.reading<EyebotCamera>().blobs.empty()) << "outside the cone of 45 degrees";
  bench.command<EyebotLaser>().on = false;
  bench.advance(kStep);
  EXPECT_TRUE(bench.robot->state().spots.empty());
}

TEST(MockEyebot, SeesAllAroundAtAnyHeight) {
  Pose start;
  start.position.z() = 1.0;
  Bench bench("eyebot", worldWith({"other", {-1.2, 0.9, 2.3}, colors::kYellow, false}), start);
  const auto& camera = bench.reading<EyebotOmnidirectionalCamera>();
  ASSERT_EQ(1U, camera.blobs.size());
  EXPECT_NEAR(1.5, camera.blobs[0].distance, 1e-6);
  EXPECT_NEAR(std::atan2(0.9, -1.2), camera.blobs[0].bearing, 1e-6);
  EXPECT_NEAR(std::atan2(0.88, 1.5), camera.blobs[0].elevation, 1e-6) << "from 1.42 m";
  EXPECT_NEAR(2.0 * std::atan(0.005 / std::hypot(1.5, 0.88)), camera.blobs[0].size, 1e-8);
  EXPECT_TRUE(bench.reading<EyebotCamera>().blobs.empty()) << "which looks down";
}

TEST(MockEyebot, TurnsACameraTowardsWhatItShallSee) {
  Pose start;
  start.position.z() = 1.0;
  // 1.7 rad to the left of the camera, and 0.6 rad below it
  const double distance = 2.1;
  const Eigen::Vector3d at(0.085 + distance * std::cos(1.7), distance * std::sin(1.7), 1.17 - distance * std::tan(0.6));
  Bench bench("eyebot", worldWith({"lamp", at, colors::kYellow, false}), start);
  const auto& camera = bench.reading<EyebotPanTiltCamera>();
  EXPECT_TRUE(camera.blobs.empty());
  bench.command<EyebotPanTilt>() = {1.7, -0.6};
  bench.advance(0.5);
  EXPECT_TRUE(camera.blobs.empty()) << "panned by 1 rad: 0.7 rad are more than half of 60 degrees";
  bench.advance(0.4);
  ASSERT_EQ(1U, camera.blobs.size());
  EXPECT_NEAR(1.7, camera.blobs[0].bearing, 1e-6);
  EXPECT_NEAR(-0.6, camera.blobs[0].elevation, 1e-6);
  EXPECT_TRUE(std::isnan(camera.blobs[0].distance));
}

TEST(MockFootbot, LooksAheadThroughALens) {
  for (const auto& [left, is_seen] : {std::pair(0.57, true), std::pair(0.584, false)}) {
    Bench bench("footbot", worldWith({"prey", {1.08, left, 0.05}, colors::kYellow, false}));
    const auto& camera = bench.reading<FootbotFrontCamera>();
    ASSERT_EQ(is_seen ? 1U : 0U, camera.blobs.size()) << "tan 30 degrees is 0.57735";
    if (is_seen) {
      EXPECT_NEAR(std::atan(0.57), camera.blobs[0].bearing, 1e-6);
      EXPECT_TRUE(std::isnan(camera.blobs[0].distance));
    }
  }
}

TEST(MockEyebot, SeesWhatIsInTheConeBelow) {
  Pose start;
  start.position.z() = 1.0;
  Bench bench("eyebot", worldWith({"prey", {1.2, 0.0, 0.0}, colors::kYellow, false}), start);
  EXPECT_TRUE(bench.reading<EyebotCamera>().blobs.empty());
  bench.command<EyebotVelocity>().linear.x() = 0.5;
  bench.advance(1.0);
  ASSERT_EQ(1U, bench.reading<EyebotCamera>().blobs.size());
  EXPECT_NEAR(0.7, bench.reading<EyebotCamera>().blobs[0].distance, 1e-6);
}

TEST(MockEyebot, HangsByItsMagnet) {
  Pose start;
  start.position.z() = 2.0;
  Bench bench("eyebot", {}, start);
  bench.command<EyebotMagnet>().on = true;
  bench.command<EyebotVelocity>().linear.z() = 0.5;
  bench.advance(0.5);
  EXPECT_FALSE(bench.reading<EyebotMagnetState>().attached);
  bench.advance(1.0);
  EXPECT_TRUE(bench.reading<EyebotMagnetState>().attached);
  EXPECT_NEAR(3.0 - 0.54, bench.robot->state().pose.position.z(), 1e-9);
  bench.command<EyebotVelocity>().linear.z() = -0.5;
  bench.advance(1.0);
  EXPECT_NEAR(3.0 - 0.54, bench.robot->state().pose.position.z(), 1e-9);
  bench.command<EyebotMagnet>().on = false;
  bench.advance(1.0);
  EXPECT_NEAR(3.0 - 0.54 - 0.5, bench.robot->state().pose.position.z(), 1e-9);
}

TEST(MockHandbot, ArmsFollowAtLimitedSpeedWithinTheirBounds) {
  Bench bench("handbot");
  bench.command<HandbotArms>().left.shoulder = -1.5;
  bench.command<HandbotArms>().right.elbow = 9.0;
  bench.advance(0.5);
  const HandbotArmsState& arms = bench.reading<HandbotArmsState>();
  EXPECT_NEAR(-1.0, arms.joints[0].angle, 1e-9);
  EXPECT_NEAR(-2.0, arms.joints[0].speed, 1e-9);
  bench.advance(1.0);
  EXPECT_NEAR(-1.5, arms.joints[0].angle, 1e-9);
  EXPECT_NEAR(1.2, arms.joints[4].angle, 1e-9);
}

TEST(MockHandbot, HoldsWhatItsHandReaches) {
  Bench bench("handbot");
  bench.command<HandbotArms>().left.shoulder = -1.0;
  bench.advance(1.0);
  bench.command<HandbotHands>().left = true;
  bench.advance(0.1);
  EXPECT_FALSE(bench.reading<HandbotHandsState>().left.holding);
  bench.command<HandbotArms>().left.shoulder = 0.0;
  bench.advance(1.0);
  EXPECT_TRUE(bench.reading<HandbotHandsState>().left.holding);
  EXPECT_FALSE(bench.reading<HandbotHandsState>().right.holding);
  EXPECT_EQ(1.0F, bench.reading<HandbotVacuum>().left[1]);
  EXPECT_EQ(0.0F, bench.reading<HandbotVacuum>().right[1]);
  EXPECT_EQ(1.0F, bench.reading<HandbotProximity>().left);
  bench.command<HandbotArms>().left.shoulder = -1.0;
  bench.advance(1.0);
  EXPECT_TRUE(bench.reading<HandbotHandsState>().left.holding) << "until it lets go";
  EXPECT_EQ(0.0F, bench.reading<HandbotProximity>().left) << "the arm is up";
}

TEST(MockHandbot, ClimbsItsRope) {
  Bench bench("handbot");
  bench.command<HandbotRope>() = {true, 0.0};
  bench.advance(0.2);
  EXPECT_FALSE(bench.reading<HandbotRopeState>().attached) << "it flies up";
  bench.advance(1.0);
  const HandbotRopeState& rope = bench.reading<HandbotRopeState>();
  EXPECT_TRUE(rope.attached);
  EXPECT_NEAR(3.0 - 0.29, rope.length, 1e-9);
  EXPECT_EQ(0.0, rope.tension);
  bench.command<HandbotRope>().winding_speed = 0.1;
  bench.advance(5.0);
  EXPECT_NEAR(3.0 - 0.29 - 0.5, rope.length, 1e-9);
  EXPECT_NEAR(0.5, bench.robot->state().pose.position.z(), 1e-9);
  EXPECT_GT(rope.tension, 0.0);
  bench.command<HandbotRope>() = {false, 0.0};
  bench.advance(1.0);
  EXPECT_FALSE(rope.attached);
  EXPECT_EQ(0.0, bench.robot->state().pose.position.z());
}

}  // namespace
}  // namespace swarmanoid::mock
