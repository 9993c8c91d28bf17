// Footbots on their treels, against the predictions from their wheels' speeds and Coulomb friction.
#include <gtest/gtest.h>

#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kWeight = 1.8 * kGravity;  // N, of a footbot
constexpr double kTreelFriction = 0.9;

class DrivingTest : public testing::TestWithParam<const char*> {};

TEST_P(DrivingTest, AFootbotStandsStill) {
  World world({{"subclock", GetParam()}});
  const Row footbot = world.addFootbot(flatPose(2.0, 3.0, 0.7));
  for (int i = 0; i < 100; ++i) {
    world.step();
    ASSERT_LT((world.pose(footbot).position - Vector3d(2.0, 3.0, 0.0)).norm(), 2e-5) << "tick " << i;
    ASSERT_LT(tiltOf(world.pose(footbot)), 1e-4) << "tick " << i;
    ASSERT_LT(world.twist(footbot).linear.norm(), 1e-4) << "tick " << i;
  }
  EXPECT_NEAR(headingOf(world.pose(footbot)), 0.7, 1e-5);
}

TEST_P(DrivingTest, StraightOnForTenSeconds) {
  World world({{"subclock", GetParam()}});
  const double heading = 0.3;
  const Row footbot = world.addFootbot(flatPose(2.0, 3.0, heading));
  world.drive(footbot, 0.1);
  world.step(100);
  const Vector3d way =
      Eigen::AngleAxisd(-heading, Vector3d::UnitZ()) * (world.pose(footbot).position - Vector3d(2.0, 3.0, 0.0));
  EXPECT_NEAR(way.x(), 1.0, 5e-3);
  EXPECT_NEAR(way.y(), 0.0, 5e-3);
  EXPECT_NEAR(way.z(), 0.0, 2e-5);
  EXPECT_NEAR(headingOf(world.pose(footbot)), heading, 0.5 * kDegree);
  EXPECT_NEAR(world.twist(footbot).linear.norm(), 0.1, 1e-4);
}

TEST_P(DrivingTest, TurnsOnTheSpot) {
  World world({{"subclock", GetParam()}});
  const Row footbot = world.addFootbot(flatPose(2.0, 3.0));
  world.drive(footbot, 0.0, 1.0);
  double turned = 0.0;
  double heading = 0.0;
  for (int i = 0; i < 100; ++i) {
    world.step();
    const double now = headingOf(world.pose(footbot));
    turned += std::remainder(now - heading, 2.0 * M_PI);
    heading = now;
  }
  EXPECT_NEAR(turned, 10.0, 0.1);
  EXPECT_NEAR(world.twist(footbot).angular.z(), 1.0, 0.01);
  EXPECT_LT((world.pose(footbot).position - Vector3d(2.0, 3.0, 0.0)).norm(), 2e-3);
}

TEST_P(DrivingTest, DrivesACircle) {
  World world({{"subclock", GetParam()}});
  const double speed = 0.2;
  const double turn_rate = 1.0;
  const Row footbot = world.addFootbot(flatPose(2.0, 3.0));
  world.drive(footbot, speed, turn_rate);
  world.step(20);  // it is up to speed
  const Pose& pose = world.pose(footbot);
  const auto centre = [&] {
    return Vector3d(pose.position + pose.orientation * Vector3d(0.0, speed / turn_rate, 0.0));
  };
  const Vector3d first_centre = centre();
  for (int i = 0; i < 100; ++i) {
    world.step();
    ASSERT_LT((centre() - first_centre).norm(), 0.01 * speed / turn_rate) << "tick " << i;
  }
  EXPECT_NEAR(world.twist(footbot).angular.z(), turn_rate, 0.01 * turn_rate);
  EXPECT_NEAR(world.twist(footbot).linear.norm(), speed, 0.01 * speed);
}

TEST(RampTest, AFootbotClimbsAndStands) {
  for (const double degrees : {5.0, 10.0, 20.0}) {
    World world;
    const Eigen::Quaterniond tilt(Eigen::AngleAxisd(-degrees * kDegree, Vector3d::UnitY()));
    // its upper face leaves the ground at x = 2.5
    world.addBlock({2.0, 1.0, 0.2}, 0.0, {Vector3d(2.5, 2.0, 0.0) + tilt * Vector3d(1.0, 0.0, -0.1), tilt});
    const Row footbot = world.addFootbot(flatPose(2.0, 2.0));
    world.drive(footbot, 0.1);
    world.step(120);
    const Vector3d on_ramp = world.pose(footbot).position - Vector3d(2.5, 2.0, 0.0);
    EXPECT_NEAR(on_ramp.norm(), 0.7, 0.03) << degrees;
    EXPECT_NEAR(on_ramp.z(), on_ramp.x() * std::tan(degrees * kDegree), 1e-3) << degrees;
    EXPECT_NEAR(tiltOf(world.pose(footbot)), degrees * kDegree, 0.3 * kDegree) << degrees;
    world.drive(footbot, 0.0);
    world.step(5);
    const Vector3d stopped = world.pose(footbot).position;
    world.step(20);
    EXPECT_LT((world.pose(footbot).position - stopped).norm(), 1e-4) << degrees;
  }
}

TEST(RampTest, BeyondTheFrictionAngleItCannotStay) {
  World world({{"treel_friction", "0.3"}});
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(-20.0 * kDegree, Vector3d::UnitY()));
  world.addBlock({2.0, 1.0, 0.2}, 0.0, {Vector3d(2.5, 2.0, 0.0) + tilt * Vector3d(1.0, 0.0, -0.1), tilt});
  const Row footbot = world.addFootbot({Vector3d(2.5, 2.0, 0.0) + tilt * Vector3d(1.0, 0.0, 0.0), tilt});
  world.step(5);
  const double expected = 0.5 * kGravity * (std::sin(20.0 * kDegree) - 0.3 * std::cos(20.0 * kDegree)) * 0.25;
  EXPECT_NEAR((tilt.conjugate() * (world.pose(footbot).position - Vector3d(2.5, 2.0, 0.0))).x(), 1.0 - expected,
              0.1 * expected);
}

INSTANTIATE_TEST_SUITE_P(Subclock, DrivingTest, testing::Values("10", "20", "50"));

}  // namespace
}  // namespace swarmanoid::dynamics3d
