// Eyebots that hover by thrust and drag.
#include <gtest/gtest.h>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

TEST(FlightTest, AnEyebotHoldsItsHeight) {
  for (const char* subclock : {"10", "50"}) {
    World world({{"subclock", subclock}});
    const Row eyebot = world.addEyebot(flatPose(2.0, 2.0, 0.5, 1.5));
    for (int tick = 0; tick < 300; ++tick) {
      world.step();
      ASSERT_LT((world.pose(eyebot).position - Vector3d(2.0, 2.0, 1.5)).norm(), 1e-3) << "tick " << tick;
    }
    EXPECT_NEAR(headingOf(world.pose(eyebot)), 0.5, 1e-6);
  }
}

TEST(FlightTest, ItHoldsItsHeightWhileItFliesAndTurns) {
  World world;
  const Row eyebot = world.addEyebot(flatPose(2.0, 2.0, 0.0, 1.5));
  for (int tick = 0; tick < 200; ++tick) {
    world.flight(eyebot).linear = {tick % 40 < 20 ? 0.5 : -0.5, tick % 60 < 30 ? 0.3 : 0.0, 0.0};
    world.flight(eyebot).yaw_rate = tick < 100 ? 0.8 : -0.5;
    world.step();
    ASSERT_NEAR(world.pose(eyebot).position.z(), 1.5, 0.02) << "tick " << tick;
    ASSERT_LT(tiltOf(world.pose(eyebot)), 0.35) << "tick " << tick;
  }
}

/// Response to a step of the command, in usual terms.
struct StepResponse {
  double rise_time = 0.0;  ///< to nine tenths [s]
  double overshoot = 0.0;  ///< of the step
  double rest = 0.0;       ///< remaining error after 5 s, of the step
};

StepResponse respond(const Vector3d& velocity) {
  World world({{"subclock", "10"}});
  world.space.clocktick = std::chrono::milliseconds(20);
  const Row eyebot = world.addEyebot(flatPose(2.0, 2.0, 0.0, 1.5));
  world.step(10);
  world.flight(eyebot).linear = velocity;
  StepResponse response;
  const double speed = velocity.norm();
  for (int tick = 1; tick <= 250; ++tick) {
    world.step();
    // of the centre of mass, since the origin, at the feet, swings when the body tilts
    const Pose& pose = world.pose(eyebot);
    const Twist& twist = world.twist(eyebot);
    const Vector3d centre = pose.orientation * robotModel("eyebot")->centre_of_mass;
    const double now = (twist.linear + twist.angular.cross(centre)).dot(velocity) / speed;
    if (response.rise_time == 0.0 && now >= 0.9 * speed) {
      response.rise_time = 0.02 * tick;
    }
    response.overshoot = std::max(response.overshoot, now / speed - 1.0);
    response.rest = std::abs(now / speed - 1.0);
  }
  return response;
}

TEST(FlightTest, AStepOfTheSpeedAheadIsFollowed) {
  const StepResponse response = respond({0.5, 0.0, 0.0});
  EXPECT_LT(response.rise_time, 0.6);
  EXPECT_LT(response.overshoot, 0.18);
  EXPECT_LT(response.rest, 0.01);
}

TEST(FlightTest, AStepOfTheSpeedUpwardsIsFollowed) {
  const StepResponse response = respond({0.0, 0.0, 0.5});
  EXPECT_LT(response.rise_time, 0.4);
  EXPECT_LT(response.overshoot, 0.12);
  EXPECT_LT(response.rest, 0.01);
}

TEST(FlightTest, VelocitiesAreInTheEyebotsOwnFrame) {
  World world;
  const Row eyebot = world.addEyebot(flatPose(2.0, 2.0, M_PI / 2.0, 1.5));
  world.flight(eyebot).linear = {0.3, 0.1, 0.2};
  world.step(100);
  EXPECT_NEAR(world.pose(eyebot).position.x(), 2.0 - 1.0, 0.05);
  EXPECT_NEAR(world.pose(eyebot).position.y(), 2.0 + 3.0, 0.05);
  EXPECT_NEAR(world.pose(eyebot).position.z(), 1.5 + 2.0, 0.05);
  EXPECT_LT((world.twist(eyebot).linear - Vector3d(-0.1, 0.3, 0.2)).norm(), 0.01);
}

TEST(FlightTest, ItTurnsAsTold) {
  World world;
  const Row eyebot = world.addEyebot(flatPose(2.0, 2.0, 0.0, 1.5));
  world.flight(eyebot).yaw_rate = 0.5;
  world.step(50);
  EXPECT_NEAR(headingOf(world.pose(eyebot)), 2.5, 0.05);
  EXPECT_NEAR(world.twist(eyebot).angular.z(), 0.5, 0.005);
  EXPECT_LT((world.pose(eyebot).position - Vector3d(2.0, 2.0, 1.5)).norm(), 0.02);
}

TEST(FlightTest, ItLandsAndStartsAgain) {
  World world;
  const Row eyebot = world.addEyebot(flatPose(2.0, 2.0, 0.0, 1.0));
  world.flight(eyebot).linear.z() = -0.3;
  world.step(60);
  EXPECT_NEAR(world.pose(eyebot).position.z(), 0.0, 1e-3);
  EXPECT_LT(world.twist(eyebot).linear.norm(), 1e-3);
  EXPECT_LT(tiltOf(world.pose(eyebot)), 0.01);
  world.flight(eyebot).linear.z() = 0.3;
  world.step(40);
  EXPECT_NEAR(world.pose(eyebot).position.z(), 1.1, 0.12);  // the set point starts below the ground
}

TEST(FlightTest, ABumpDoesNotBringItDown) {
  World world;
  const Row eyebot = world.addEyebot(flatPose(2.0, 2.0, 0.0, 1.0));
  world.addBlock({0.1, 4.0, 3.0}, 0.0, flatPose(3.0, 2.0, 0.0, 1.5));
  world.flight(eyebot).linear = {0.5, 0.0, 0.0};
  world.step(60);  // against the wall
  EXPECT_LT(world.pose(eyebot).position.x(), 2.95 - 0.25 + 0.01);
  EXPECT_GT(world.pose(eyebot).position.x(), 2.5);
  EXPECT_NEAR(world.pose(eyebot).position.z(), 1.0, 0.1);
  world.flight(eyebot).linear = {-0.5, 0.0, 0.0};
  world.step(40);
  EXPECT_LT(world.pose(eyebot).position.x(), 1.5);
  EXPECT_NEAR(world.pose(eyebot).position.z(), 1.0, 0.05);
}

TEST(FlightTest, WithoutItsFlightControllerItFalls) {
  World world;
  const Row eyebot = world.add(robotModel("eyebot"), flatPose(2.0, 2.0, 0.0, 1.0));
  world.step(3);
  EXPECT_NEAR(world.pose(eyebot).position.z(), 1.0 - 0.5 * kGravity * 0.09, 0.02);
  world.step(20);
  EXPECT_NEAR(world.pose(eyebot).position.z(), 0.0, 1e-3);
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
