// Friction opposes the slip in any direction, with Coulomb's size; also under treels, which slip against a belt.
#include <gtest/gtest.h>

#include <set>

#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Angle from one vector to another about z [rad].
double turnBetween(const Vector3d& from, const Vector3d& to) { return std::atan2(from.cross(to).z(), from.dot(to)); }

/// Direction against the axes of W [degrees].
class DirectionTest : public testing::TestWithParam<double> {
 protected:
  double direction() const { return GetParam() * kDegree; }
};

TEST_P(DirectionTest, SlippingTreelsAreBrakedAgainstTheirSlip) {
  // a footbot that is thrown sideways, with treels that run backwards faster and faster: the slip takes all directions
  constexpr double kFriction = 0.21;
  constexpr double kStep = 0.01;  // s
  World world({{"treel_friction", "0.21"}, {"subclock", "1"}});
  world.space.clocktick = std::chrono::milliseconds(10);
  std::vector<Treels> treels;
  world.engine.record(&treels);
  const Row footbot = world.addFootbot(flatPose(3.0, 3.0, 0.31));
  const Vector3d ahead(std::cos(0.31), std::sin(0.31), 0.0);
  world.twist(footbot).linear = 0.53 * (Eigen::AngleAxisd(direction(), Vector3d::UnitZ()) * ahead);
  world.engine.place(world.space, footbot);
  world.drive(footbot, ahead.dot(world.twist(footbot).linear) > 0.0 ? -0.3 : 0.3);
  int compared = 0;
  for (int i = 0; i < 12; ++i) {
    const Vector3d before = world.twist(footbot).linear;
    world.step();
    const Vector3d slip = before - treels.back().rim_speed[0] * ahead;
    const Vector3d change = world.twist(footbot).linear - before;
    if (i < 2 || slip.norm() < 0.1) {
      continue;  // it settles on its treels, or is about to stop
    }
    ++compared;
    // the slip turns a little during the step, so its mean is used
    const Vector3d middle = slip + 0.5 * change;
    ASSERT_NEAR(turnBetween(change, -middle), 0.0, 1.0 * kDegree) << "step " << i;
    const double expected = kFriction * (kGravity * kStep + change.z());  // it pitches on its treels
    ASSERT_NEAR(change.head<2>().norm(), expected, 0.03 * expected) << "step " << i;
  }
  EXPECT_GT(compared, 5);
}

TEST_P(DirectionTest, ABrakedFootbotSlidesDownASlope) {
  const double angle = 20.0 * kDegree;
  World world({{"treel_friction", "0.3"}});
  const Quaterniond tilt(Eigen::AngleAxisd(angle, Vector3d(0.6, 0.8, 0.0)));
  world.addBlock({4.0, 4.0, 0.2}, 0.0, {Vector3d(5.0, 5.0, 2.0), tilt});
  const Quaterniond turned = tilt * Quaterniond(Eigen::AngleAxisd(direction(), Vector3d::UnitZ()));
  const Row footbot = world.addFootbot({Vector3d(5.0, 5.0, 2.0) + tilt * Vector3d(0.0, 0.0, 0.1), turned});
  const Vector3d start = world.pose(footbot).position;
  world.step(10);
  const Vector3d down = tilt * Vector3d(0.8, -0.6, 0.0);
  const Vector3d way = world.pose(footbot).position - start;
  const double expected = 0.5 * kGravity * (std::sin(angle) - 0.3 * std::cos(angle));
  EXPECT_NEAR(way.dot(down), expected, 0.03 * expected);
  EXPECT_LT((way - way.dot(down) * down).norm(), 0.03 * expected);
}

TEST_P(DirectionTest, AThrownPreyStopsOnItsLine) {
  World world({{"friction", "0.43"}});
  const Row prey = world.addToSpace(cylindricPreyModel(0.07, 0.11, 0.9), flatPose(3.0, 3.0, 0.13));
  const Vector3d along(std::cos(direction()), std::sin(direction()), 0.0);
  world.twist(prey).linear = 1.37 * along;
  test::carryOut(world.space);
  world.engine.add(world.space, prey, Role::kMove);
  world.step(10);
  const Vector3d way = world.pose(prey).position - Vector3d(3.0, 3.0, 0.0);
  // half a step of 10 ms is missing: the integrator moves by the velocity at the end of each step
  const double expected = 1.37 * 1.37 / (2.0 * 0.43 * kGravity) - 0.5 * 0.01 * 1.37;
  EXPECT_NEAR(way.dot(along), expected, 5e-3 * expected);
  EXPECT_LT((way - way.dot(along) * along).norm(), 1e-3);
}

TEST_P(DirectionTest, WhatRestsHoldsUntilCoulombsLimit) {
  // a block pulled only by a slope, in any direction relative to its own edges and to the slope
  const double limit = std::atan(0.37);
  for (const double part : {0.98, 1.02}) {
    World world({{"friction", "0.37"}});
    const Vector3d axis(-std::sin(direction()), std::cos(direction()), 0.0);
    const Quaterniond tilt(Eigen::AngleAxisd(part * limit, axis));
    world.addBlock({4.0, 4.0, 0.2}, 0.0, {Vector3d(5.0, 5.0, 2.0), tilt});
    const Row block =
        world.addBlock({0.3, 0.2, 0.06}, 0.7, {Vector3d(5.0, 5.0, 2.0) + tilt * Vector3d(0.0, 0.0, 0.13), tilt});
    const Vector3d start = world.pose(block).position;
    world.step(20);
    const double expected = 2.0 * kGravity * (std::sin(part * limit) - 0.37 * std::cos(part * limit));
    EXPECT_NEAR((world.pose(block).position - start).norm(), std::max(expected, 0.0), 0.01) << part;
  }
}

INSTANTIATE_TEST_SUITE_P(Sixteen, DirectionTest, testing::Range(7.0, 367.0, 22.5));

TEST(FrictionTest, AlongASmoothWallARobotIsAsFastAsItsTreelsAlongIt) {
  // the wall pushes along its normal, through the robot's axis; so friction and slip are along the normal too, and the
  // slip is the commanded speed into the wall
  for (const double degrees : {55.0, 63.0, 71.0}) {
    World world({{"friction", "0"}, {"treel_friction", "0.4"}});
    const double across = degrees * kDegree;  // from straight at the wall
    const Quaterniond turn(Eigen::AngleAxisd(0.29, Vector3d::UnitZ()));
    const auto turned = [&](double x, double y, double heading, double z) {
      return Pose{turn * Vector3d(x, y, 0.0) + Vector3d(5.0, 5.0, z),
                  turn * Quaterniond(Eigen::AngleAxisd(heading, Vector3d::UnitZ()))};
    };
    world.addBlock({0.1, 8.0, 0.5}, 0.0, turned(0.05, 0.0, 0.0, 0.25));
    const Row footbot = world.addFootbot(turned(-0.086, -1.0, across, 0.0));
    world.drive(footbot, 0.2);
    world.step(20);
    const Vector3d start = world.pose(footbot).position;
    const double before = headingOf(world.pose(footbot));
    world.step(20);
    const Vector3d way = turn.conjugate() * (world.pose(footbot).position - start);
    const double heading = 0.5 * (before + headingOf(world.pose(footbot))) - 0.29;
    EXPECT_NEAR(way.y(), 2.0 * 0.2 * std::sin(heading), 0.02 * 0.4) << degrees;
    EXPECT_NEAR(way.x(), 0.0, 1e-3) << degrees;
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
