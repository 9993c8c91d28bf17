// Mock robots move as commanded, and their sensors show the motion.
#include <gtest/gtest.h>

#include <cmath>

#include "../src/mock/mock_robot.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"

namespace swarmanoid::mock {
namespace {

constexpr double kStep = 0.02;  // [s]

struct Bench {
  explicit Bench(std::unique_ptr<MockRobot> mock) : robot(std::move(mock)) {}

  template <class Device>
  Device& command() {
    for (const MockRobot::Actuator& actuator : robot->actuators()) {
      if (actuator.device == Device::kType) {
        return *static_cast<Device*>(actuator.command);
      }
    }
    throw std::logic_error("no such actuator");
  }
  template <class Device>
  const Device& reading() const {
    for (const MockRobot::Sensor& sensor : robot->sensors()) {
      if (sensor.device == Device::kType) {
        return *static_cast<const Device*>(sensor.reading);
      }
    }
    throw std::logic_error("no such sensor");
  }
  void advance(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep)); ++i) {
      robot->advance(kStep);
    }
  }

  std::unique_ptr<MockRobot> robot;
};

World worldWith(Beacon beacon) {
  World world;
  world.beacons.push_back(std::move(beacon));
  return world;
}

TEST(MockFootbot, DrivesStraightAndTurnsLeft) {
  Bench bench(makeMockFootbot({}, {}));
  bench.command<FootbotWheels>().drive(0.1, 0.0);
  bench.advance(2.0);
  EXPECT_NEAR(0.2, bench.robot->pose().position.x(), 1e-9);
  bench.command<FootbotWheels>().drive(0.0, 0.5);
  bench.advance(1.0);
  EXPECT_NEAR(0.5, bench.robot->pose().yaw, 1e-9);
}

TEST(MockFootbot, DrivesACircleBackToItsStart) {
  Bench bench(makeMockFootbot({}, {}));
  bench.command<FootbotWheels>().drive(0.1, 2.0 * M_PI / 10.0);
  bench.advance(2.5);
  const double radius = 0.1 / (2.0 * M_PI / 10.0);
  EXPECT_NEAR(radius, bench.robot->pose().position.x(), 1e-9);
  EXPECT_NEAR(radius, bench.robot->pose().position.y(), 1e-9);
  bench.advance(7.5);
  EXPECT_NEAR(0.0, bench.robot->pose().position.norm(), 1e-9);
}

TEST(MockFootbot, FeelsAWallWhereItIs) {
  World world;
  world.walls.push_back({{-1.0, 0.135}, {1.0, 0.135}});  // on its left
  Bench bench(makeMockFootbot(world, {}));
  const FootbotProximity& proximity = bench.reading<FootbotProximity>();
  EXPECT_NEAR(0.5F, proximity.value[6], 1e-6F) << "0.05 m from its side, half the range";
  EXPECT_EQ(0.0F, proximity.value[0]);
  EXPECT_EQ(0.0F, proximity.value[18]);
  EXPECT_EQ(proximity.value[5], proximity.value[7]);
  EXPECT_LT(proximity.value[5], proximity.value[6]);
}

TEST(MockFootbot, SeesABeaconMoveAsItDrives) {
  Bench bench(makeMockFootbot(worldWith({"prey", {1.0, 1.0, 0.0}, colors::kYellow, false}), {}));
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

TEST(MockFootbot, GripsWhatIsNearAndTakesItAlong) {
  Bench bench(makeMockFootbot(worldWith({"prey", {0.3, 0.0, 0.05}, colors::kYellow, true}), {}));
  bench.command<FootbotGripper>().close();
  bench.advance(0.1);
  EXPECT_FALSE(bench.reading<FootbotGripperState>().gripping) << "out of reach";
  bench.command<FootbotWheels>().drive(0.1, 0.0);
  bench.advance(2.0);
  EXPECT_TRUE(bench.reading<FootbotGripperState>().gripping);
  EXPECT_NEAR(0.31, bench.robot->world().beacons[0].at.x(), 1e-9) << "at its tip";
  bench.command<FootbotGripper>().open();
  bench.advance(0.5);
  EXPECT_FALSE(bench.reading<FootbotGripperState>().gripping);
  EXPECT_NEAR(0.31, bench.robot->world().beacons[0].at.x(), 1e-9);
}

TEST(MockFootbot, TurretFollows) {
  Bench bench(makeMockFootbot({}, {}));
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
  Bench bench(makeMockEyebot({}, start));
  bench.command<EyebotVelocity>().linear = {0.2, 0.1, 0.3};
  bench.advance(1.0);
  EXPECT_NEAR(-0.1, bench.robot->pose().position.x(), 1e-9);
  EXPECT_NEAR(0.2, bench.robot->pose().position.y(), 1e-9);
  EXPECT_NEAR(1.3, bench.robot->pose().position.z(), 1e-9);
  bench.command<EyebotVelocity>().linear = {0.0, 0.0, -0.5};
  bench.advance(5.0);
  EXPECT_EQ(0.0, bench.robot->pose().position.z()) << "the ground";
}

TEST(MockEyebot, SeesWhatIsInTheConeBelow) {
  Pose start;
  start.position.z() = 1.0;
  Bench bench(makeMockEyebot(worldWith({"prey", {1.2, 0.0, 0.0}, colors::kYellow, false}), start));
  EXPECT_TRUE(bench.reading<EyebotCamera>().blobs.empty());
  bench.command<EyebotVelocity>().linear.x() = 0.5;
  bench.advance(1.0);
  ASSERT_EQ(1U, bench.reading<EyebotCamera>().blobs.size());
  EXPECT_NEAR(0.7, bench.reading<EyebotCamera>().blobs[0].distance, 1e-6);
}

TEST(MockEyebot, HangsByItsMagnet) {
  Pose start;
  start.position.z() = 2.0;
  Bench bench(makeMockEyebot({}, start));
  bench.command<EyebotMagnet>().on = true;
  bench.command<EyebotVelocity>().linear.z() = 0.5;
  bench.advance(0.5);
  EXPECT_FALSE(bench.reading<EyebotMagnetState>().attached);
  bench.advance(1.0);
  EXPECT_TRUE(bench.reading<EyebotMagnetState>().attached);
  EXPECT_NEAR(3.0 - 0.54, bench.robot->pose().position.z(), 1e-9);
  bench.command<EyebotVelocity>().linear.z() = -0.5;
  bench.advance(1.0);
  EXPECT_NEAR(3.0 - 0.54, bench.robot->pose().position.z(), 1e-9);
  bench.command<EyebotMagnet>().on = false;
  bench.advance(1.0);
  EXPECT_NEAR(3.0 - 0.54 - 0.5, bench.robot->pose().position.z(), 1e-9);
}

TEST(MockHandbot, ArmsFollowAtLimitedSpeedWithinTheirBounds) {
  Bench bench(makeMockHandbot({}, {}));
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
  Bench bench(makeMockHandbot({}, {}));
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
  Bench bench(makeMockHandbot({}, {}));
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
  EXPECT_NEAR(0.5, bench.robot->pose().position.z(), 1e-9);
  EXPECT_GT(rope.tension, 0.0);
  bench.command<HandbotRope>() = {false, 0.0};
  bench.advance(1.0);
  EXPECT_FALSE(rope.attached);
  EXPECT_EQ(0.0, bench.robot->pose().position.z());
}

TEST(MockDriversWatchdog, StopsWhatHasHadNoCommandForTooLong) {
  Bench bench(makeMockFootbot({}, {}));
  CommandWatchdog watchdog(*bench.robot, 0.5);
  const auto advance = [&](double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep)); ++i) {
      watchdog.advance(kStep);
      bench.robot->advance(kStep);
    }
  };
  bench.command<FootbotWheels>().drive(0.1, 0.0);
  bench.command<FootbotGripper>().close();
  watchdog.commanded(0);
  advance(0.4);
  watchdog.commanded(0);
  advance(0.4);
  EXPECT_NEAR(0.08, bench.robot->pose().position.x(), 1e-9);
  advance(1.0);
  EXPECT_TRUE(watchdog.hasExpired(0));
  EXPECT_FALSE(watchdog.hasExpired(1)) << "it never had a command";
  EXPECT_EQ(0.0, bench.command<FootbotWheels>().left);
  EXPECT_TRUE(bench.command<FootbotGripper>().closed);
  EXPECT_NEAR(0.09, bench.robot->pose().position.x(), 0.0021);
}

TEST(MockWorld, IsReadFromParametersAndRefusesOthers) {
  Configuration values("world", "", {"/w", 0});
  Configuration& walls = values.add(Configuration("walls", "", {"/w", 0}));
  walls.set("front", "1, -1, 1, 1");
  EXPECT_NEAR(1.0, distanceToWall(readWorld(values), {0.0, 0.0}, 0.0), 1e-12);
  EXPECT_NEAR(std::sqrt(1.25), distanceToWall(readWorld(values), {0.0, 0.0}, std::atan(0.5)), 1e-12);
  EXPECT_TRUE(std::isinf(distanceToWall(readWorld(values), {0.0, 0.0}, M_PI)));
  EXPECT_TRUE(std::isinf(distanceToWall(readWorld(values), {0.0, 2.0}, 0.0)));
  EXPECT_THROW(makeMockRobot("footboot", values), ConfigError);
  values.set("ceilin", "2");
  EXPECT_THROW(makeMockRobot("footbot", values), ConfigError);
}

}  // namespace
}  // namespace swarmanoid::mock
