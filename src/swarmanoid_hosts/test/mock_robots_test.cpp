// Mock robots move as commanded, and their sensors show the motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mock_bench.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/ground.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/devices/holders.hpp"
#include "swarmanoid_interface/devices/imu.hpp"
#include "swarmanoid_interface/devices/joints.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid::mock {
namespace {

World worldWith(Beacon beacon) {
  World world;
  world.beacons.push_back(std::move(beacon));
  return world;
}

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

/// The simulator's sensor has the same law: a test of its own holds it against the same polynomial.
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

/// A grey disc and a green one, the later of which lies on the earlier one where they overlap.
World worldWithDiscs() {
  World world;
  world.discs.push_back({{0.17, 0.25}, 0.06, colors::kGray});
  world.discs.push_back({{0.1, 0.25}, 0.045, colors::kGreen});
  return world;
}

/// Which disc is under which spot was worked out by another program.
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

TEST(MockRangeAndBearing, HearsBeaconsThatSaySomething) {
  World world;
  world.beacons.push_back({"mute", {0.5, 0.0, 0.0}, colors::kRed, false});
  world.beacons.push_back({"nest", {0.6, 0.8, 1.0}, colors::kGreen, false, {7, 255}});
  world.beacons.push_back({"far", {-3.01, 0.0, 0.0}, colors::kGreen, false, {9}});
  Bench bench({"differential_drive", "range_and_bearing", "range_and_bearing_received"}, world);
  const RangeAndBearingReceived& received = bench.reading<RangeAndBearingReceived>();
  ASSERT_EQ(1U, received.messages.size());
  EXPECT_NEAR(std::sqrt(2.0), received.messages[0].range, 1e-6);
  EXPECT_NEAR(0.927295, received.messages[0].bearing, 1e-6) << "4 to the left for each 3 ahead";
  EXPECT_NEAR(M_PI / 4.0, received.messages[0].elevation, 1e-6) << "1 m away and 1 m up";
  EXPECT_EQ((RangeAndBearing::Payload{7, 255}), received.messages[0].payload);
  EXPECT_FALSE(received.overflowed);
  bench.command<RangeAndBearing>().send({1});
  bench.command<DifferentialDrive>().drive(-0.1, 0.0);
  bench.advance(1.0);
  ASSERT_EQ(2U, received.messages.size()) << "it does not hear itself";
  EXPECT_NEAR(2.91, received.messages[1].range, 1e-6);
  EXPECT_EQ(static_cast<float>(M_PI), received.messages[1].bearing);
  EXPECT_EQ(9, received.messages[1].payload[0]);
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
  const double left = 1.65 * std::tan(0.5);  // from 0.05 m ahead, 0.15 m above where it stands
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
  bench.command<HandbotArms>().left.shoulder = -1.0;
  bench.advance(1.0);
  EXPECT_TRUE(bench.reading<HandbotHandsState>().left.holding) << "until it lets go";
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

/// The simulator's sensor has the same law: a test of its own holds it against the same formula.
TEST(MockRobotOfAnyType, FeelsTheLightOfBeacons) {
  Bench bench(std::vector<std::string>{Light::kType}, worldWith({"lamp", {0.0, 0.535, 0.0}, colors::kWhite, false}));
  const Light& light = bench.reading<Light>();
  ASSERT_EQ(8U, light.sensors.size());
  EXPECT_NEAR(M_PI / 2.0, light.sensors[2].angle, 1e-6);
  EXPECT_NEAR(0.04F, light.sensors[2].value, 1e-6F) << "0.5 m straight ahead of it";
  // 45 degrees aside the sensor is 0.510851 m away from the beacon, which it sees at a cosine of 0.672020
  EXPECT_NEAR(0.0257510F, light.sensors[1].value, 1e-6F);
  EXPECT_NEAR(0.0257510F, light.sensors[3].value, 1e-6F);
  EXPECT_EQ(0.0F, light.sensors[0].value);
  EXPECT_EQ(0.0F, light.sensors[6].value);
  bench.robot->place({{0.0, -1.6, 0.0}, 0.0});
  EXPECT_EQ(0.0F, light.sensors[2].value) << "2.1 m away";
}

TEST(MockRobotOfAnyType, ReadsTheFloorUnderIt) {
  World world = worldWithDiscs();
  world.ring = {5, 0.05};
  Bench bench(std::vector<std::string>{Ground::kType}, world);
  bench.robot->place({{0.13, 0.27, 0.0}, 0.83});
  const Ground& ground = bench.reading<Ground>();
  ASSERT_EQ(5U, ground.spots.size());
  EXPECT_NEAR(0.05 * std::cos(0.4 * M_PI), ground.spots[1].x, 1e-7);
  EXPECT_NEAR(0.05 * std::sin(0.4 * M_PI), ground.spots[1].y, 1e-7);
  const float expected[] = {128.0F / 255.0F, 1.0F, 1.0F / 3.0F, 1.0F / 3.0F, 128.0F / 255.0F};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(expected[i], ground.spots[i].value, 1e-6) << i;
  }
  bench.robot->place({{0.13, 0.27, 0.049}, 0.83});
  EXPECT_EQ(1.0F, ground.spots[1].value);
  bench.robot->place({{0.13, 0.27, 0.051}, 0.83});
  EXPECT_EQ(0.0F, ground.spots[1].value) << "too high over it";
}

TEST(MockRobotOfAnyType, FeelsGravityAndItsOwnTurning) {
  Bench bench(std::vector<std::string>{Imu::kType, DifferentialDrive::kType});
  const Imu& imu = bench.reading<Imu>();
  EXPECT_EQ(0.0, imu.angular_velocity.norm());
  EXPECT_EQ(Eigen::Vector3d(0.0, 0.0, 9.81), imu.linear_acceleration);
  bench.command<DifferentialDrive>().drive(0.2, -1.5);
  bench.advance(0.1);
  EXPECT_EQ(Eigen::Vector3d(0.0, 0.0, -1.5), imu.angular_velocity);
  EXPECT_NEAR(-0.3, imu.linear_acceleration.y(), 1e-12) << "speed times turn rate, to the right";
  EXPECT_NEAR(0.0, imu.linear_acceleration.x(), 1e-12);
  EXPECT_NEAR(9.81, imu.linear_acceleration.z(), 1e-12);
}

TEST(MockRobotOfAnyType, TurnsItsJoints) {
  World world;
  world.joints = {3, 1.5};
  Bench bench(std::vector<std::string>{Joints::kType, JointStates::kType}, world);
  const Span<const JointStates::Joint> joints = bench.reading<JointStates>().joints;
  ASSERT_EQ(3U, joints.size());
  bench.command<Joints>().joints[0].holdAngle(0.7);
  bench.command<Joints>().joints[1].turnAt(-0.4);
  bench.command<Joints>().joints[2].turnAt(9.0);
  bench.advance(0.2);
  EXPECT_NEAR(0.3, joints[0].angle, 1e-9) << "at 1.5 rad/s";
  EXPECT_NEAR(-0.08, joints[1].angle, 1e-9);
  EXPECT_NEAR(0.3, joints[2].angle, 1e-9) << "no faster than its motor";
  EXPECT_NEAR(1.5, joints[2].speed, 1e-9);
  bench.command<Joints>().joints[2].letTurn();
  bench.advance(0.4);
  EXPECT_NEAR(0.7, joints[0].angle, 1e-9);
  EXPECT_NEAR(-0.24, joints[1].angle, 1e-9);
  EXPECT_NEAR(0.3, joints[2].angle, 1e-9);
  EXPECT_EQ(0.0, joints[2].speed);
  EXPECT_EQ(0.0, joints[0].effort);
}

TEST(MockRobotOfAnyType, HoldsAndWinds) {
  World world;
  world.holders = {2, 1.6};
  Bench bench(std::vector<std::string>{Holders::kType, HolderStates::kType}, world);
  const Span<const HolderStates::Holder> holders = bench.reading<HolderStates>().holders;
  ASSERT_EQ(2U, holders.size());
  bench.command<Holders>().holders[1].holds = true;
  bench.advance(0.1);
  EXPECT_FALSE(holders[0].is_holding);
  EXPECT_TRUE(holders[1].is_holding);
  EXPECT_NEAR(1.6, holders[1].length, 1e-9);
  EXPECT_GT(holders[1].force, 0.0);
  bench.command<Holders>().holders[1].winding_speed = 0.15;
  bench.advance(2.0);
  EXPECT_NEAR(1.3, holders[1].length, 1e-9);
  bench.command<Holders>().holders[1].winding_speed = -5.0;
  bench.advance(1.0);
  EXPECT_NEAR(1.5, holders[1].length, 1e-9) << "at 0.2 m/s";
  bench.advance(1.0);
  EXPECT_NEAR(1.6, holders[1].length, 1e-9) << "there is no more on the winch";
  bench.command<Holders>().holders[1].holds = false;
  bench.advance(0.1);
  EXPECT_FALSE(holders[1].is_holding);
  EXPECT_EQ(0.0, holders[1].length);
}

}  // namespace
}  // namespace swarmanoid::mock
