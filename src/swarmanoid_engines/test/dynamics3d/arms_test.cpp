// Arms and hands of handbots.
#include <gtest/gtest.h>

#include <cmath>

#include "handbot_world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

const ArmAngles kPose{-0.8, 0.5, 1.0};

TEST(ArmsTest, GoWhereTheyAreTold) {
  HandbotWorld world;
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  world.arms(robot).left = kPose;
  world.step(30);
  EXPECT_NEAR(world.angle(robot, "left_shoulder"), -0.8, 1e-3);
  EXPECT_NEAR(world.angle(robot, "left_elbow"), 0.5, 1e-3);
  EXPECT_NEAR(world.angle(robot, "left_wrist"), 1.0, 1e-3);
  for (const char* joint : {"right_shoulder", "right_elbow", "right_wrist"}) {
    EXPECT_NEAR(world.angle(robot, joint), 0.0, 1e-3) << joint;
  }
  EXPECT_LT(tiltOf(world.pose(robot)), 0.01);
}

TEST(ArmsTest, TurnNoFasterThanTheirMotors) {
  HandbotWorld world;
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  world.arms(robot).left.wrist = 3.0;
  world.step(10);
  EXPECT_NEAR(world.angle(robot, "left_wrist"), 2.0, 0.05);  // 2 rad/s for 1 s
}

TEST(ArmsTest, MotorsHoldWhatHangsOnThem) {
  HandbotWorld world;
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  world.step(30);
  const EntityModel& model = *robotModel("handbot");
  const double shoulder = model.mount("left_upper_arm").position.x();
  double torque = 0.0;
  for (const char* name : {"left_shoulder", "left_elbow", "left_wrist"}) {
    const Inertial& part = model.joints[static_cast<std::size_t>(HandbotWorld::indexOf(name))].part;
    torque += part.mass * kGravity * (part.centre_of_mass.x() - shoulder);
  }
  // it is stretched ahead, and positive angles lower it: the motor lifts
  EXPECT_NEAR(world.effort(robot, "left_shoulder"), -torque, 0.01 * torque);
}

TEST(ArmsTest, RaysHitThemWhereTheyAre) {
  HandbotWorld world;
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  const Vector3d hand(2.17, 2.11, 0.5);
  EXPECT_EQ(world.castRay(hand, {hand.x(), hand.y(), 0.01}).row, robot);
  world.arms(robot).left.shoulder = -1.5;
  world.step(20);
  EXPECT_EQ(world.castRay({hand.x(), hand.y(), 0.31}, {hand.x(), hand.y(), 0.01}).row, kNoRow);
  EXPECT_EQ(world.castRay({2.04, 1.0, 0.31}, {2.04, 2.5, 0.31}).row, robot);
}

TEST(HandsTest, TakeLiftAndLetGo) {
  HandbotWorld world;
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  // a box under the left hand, as high as the cups
  const Row box = world.addBlock({0.06, 0.06, 0.12}, 0.1, flatPose(2.24, 2.11, 0.0, 0.15));
  const Row table = world.addBlock({0.2, 0.2, 0.09}, 0.0, flatPose(2.3, 2.11, 0.0, 0.045));
  world.hands(robot).left = true;
  world.step(5);
  ASSERT_EQ(world.held(robot, kLeftHand).held, box);
  world.arms(robot).left.shoulder = -0.6;
  world.step(30);
  EXPECT_GT(world.pose(box).position.z(), 0.24);
  EXPECT_NEAR(world.held(robot, kLeftHand).force, 0.1 * kGravity, 0.02);
  world.hands(robot).left = false;
  world.step(20);
  EXPECT_FALSE(world.space.attachments.isAttached(robot));
  EXPECT_LT(world.pose(box).position.z(), 0.2);
  (void)table;
}

TEST(HandsTest, HoldNothingOutOfReach) {
  HandbotWorld world;
  const Row robot = world.addHandbot(flatPose(2.0, 2.0));
  world.addBlock({0.1, 0.6, 0.4}, 0.0, flatPose(2.27, 2.0, 0.0, 0.2));  // 15 mm before the cups
  world.hands(robot).left = true;
  world.hands(robot).right = true;
  world.step(10);
  EXPECT_FALSE(world.space.attachments.isAttached(robot));
}

/// A handbot that holds a beam above it with its right hand, until its stand is removed.
/// @param share of its weight that the hand can hold @return text of the event in which the hand comes off; "": it
/// holds on
std::string hangByAHand(double gravity, double share) {
  const double weight = robotModel("handbot")->mass * gravity;
  HandbotWorld world({{"gravity", std::to_string(gravity)}, {"suction_strength", std::to_string(share * weight)}});
  const Row stand = world.addBlock({0.5, 0.5, 0.1}, 0.0, flatPose(2.0, 2.0, 0.0, 0.05));
  const Row robot = world.addHandbot(flatPose(2.0, 2.0, 0.0, 0.1));
  world.arms(robot).right.shoulder = -1.57;
  world.step(30);
  const Mount cups = placeOf(*robotModel("handbot"), world.space.joints[robot], "right_suction");
  const Vector3d at = world.pose(robot).position + world.pose(robot).orientation * cups.position;
  world.addBlock({0.1, 0.1, 0.1}, 0.0, flatPose(at.x(), at.y(), 0.0, at.z() + 0.055));
  world.hands(robot).right = true;
  world.step(20);
  EXPECT_TRUE(world.space.attachments.isAttached(robot, kRightHand));
  EXPECT_LT(world.held(robot, kRightHand).force, 0.1 * weight);
  world.remove(stand);
  for (int i = 0; i < 100; ++i) {
    world.step();
    if (!world.space.events.empty()) {
      EXPECT_FALSE(world.space.attachments.isAttached(robot, kRightHand));
      return world.space.events[0].text;
    }
  }
  EXPECT_NEAR(world.held(robot, kRightHand).force, weight, 0.01 * weight);
  return "";
}

TEST(HandsTest, ComeOffAtTheStatedForce) {
  for (const double gravity : {9.81, 15.0}) {
    EXPECT_EQ(hangByAHand(gravity, 1.05), "");
    EXPECT_EQ(hangByAHand(gravity, 0.95).rfind("right hand: torn off: pulled with more than ", 0), 0U);
  }
}

TEST(MagnetTest, HoldsAnEyebotAtTheCeilingWithItsRotorsAtRest) {
  for (const bool is_ferromagnetic : {true, false}) {
    HandbotWorld world({}, is_ferromagnetic);
    const Row eyebot = world.addRobot<EyebotVelocity, EyebotMagnet>(robotModel("eyebot"), flatPose(2.0, 2.0, 0.0, 1.6));
    world.space.actuation.bank<EyebotMagnet>().find(eyebot)->on = true;
    world.flight(eyebot).linear.z() = 0.2;
    world.step(40);
    world.flight(eyebot).linear.z() = 0.0;
    world.step(30);
    EXPECT_EQ(world.space.attachments.isAttached(eyebot, kMagnet), is_ferromagnetic);
    if (is_ferromagnetic) {
      const double weight = robotModel("eyebot")->mass * kGravity;
      EXPECT_NEAR(world.held(eyebot, kMagnet).force, weight, 0.01 * weight);
      EXPECT_LT(world.twist(eyebot).linear.norm(), 1e-4);
      const double height = world.pose(eyebot).position.z();
      world.space.actuation.bank<EyebotMagnet>().find(eyebot)->on = false;
      world.step(50);
      EXPECT_FALSE(world.space.attachments.isAttached(eyebot));
      EXPECT_NEAR(world.pose(eyebot).position.z(), height, 0.02);
    }
  }
}

TEST(MagnetTest, ComesOffAtTheStatedForce) {
  const double weight = robotModel("eyebot")->mass * kGravity;
  for (const double share : {0.95, 1.05}) {
    HandbotWorld world({{"magnet_strength", std::to_string(share * weight)}});
    const Row eyebot = world.addRobot<EyebotVelocity, EyebotMagnet>(robotModel("eyebot"), flatPose(2.0, 2.0, 0.0, 1.9));
    world.space.actuation.bank<EyebotMagnet>().find(eyebot)->on = true;
    world.flight(eyebot).linear.z() = 0.05;
    std::string text;
    for (int i = 0; i < 60; ++i) {
      world.step();
      for (const Event& event : world.space.events) {
        text += event.text + ";";
      }
    }
    EXPECT_EQ(text.find("magnet: torn off") != std::string::npos, share < 1.0) << text;
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
