// Friction with the ground is Coulomb's: against the slip, as large as the weight allows, in any direction.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/coulomb_friction.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTreelFriction = 0.9;
constexpr double kMass = 1.8;        // kg, of a footbot
constexpr double kHalfTrack = 0.07;  // m
constexpr double kDegree = M_PI / 180.0;

double direction(int k) { return (7.0 + 22.5 * k) * kDegree; }

Vector2d along(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Angle between two directions [rad].
double angleBetween(const Vector2d& a, const Vector2d& b) {
  return std::abs(std::atan2(planar::cross(a, b), a.dot(b)));
}

struct Motion {
  Vector2d velocity = Vector2d::Zero();  ///< [m/s]
  double turn_rate = 0.0;                ///< [rad/s]

  Vector2d at(const Vector2d& arm) const { return velocity + turn_rate * Vector2d(-arm.y(), arm.x()); }
};

/// A footbot in motion, alone, or with its gripper closed on a prey of almost no weight, so that it is solved in an
/// island together with the prey.
class Slider {
 public:
  Slider(double heading, const Motion& motion, bool holds, int subclock)
      : world(worldWith({{"ground_friction", "0"}}, subclock)) {
    footbot = world.addToSpace(footbotModel(), flatPose(5.0, 5.0, heading));
    const Vector2d arm = 0.215 * along(heading);
    const Row prey = world.addToSpace(cylindricPreyModel(0.1, 0.1, 1e-3), flatPose(5.0 + arm.x(), 5.0 + arm.y()));
    set(footbot, motion.velocity, motion.turn_rate);
    set(prey, motion.at(arm), motion.turn_rate);
    world.space.actuation.bank<FootbotWheels>().add(footbot);
    world.space.actuation.bank<FootbotGripper>().add(footbot);
    world.setGripper(footbot, holds);
    if (holds) {
      EXPECT_TRUE(world.space.structure.connect(footbot, prey));
      test::carryOut(world.space);
      world.engine.add(world.space, prey, Role::kMove);
    }
    test::carryOut(world.space);
    world.engine.add(world.space, footbot, Role::kMove);
  }
  void tick(std::chrono::microseconds dt) {
    test::carryOut(world.space);
    world.engine.move(world.space, MoveAccess(world.space), dt);
    world.engine.connect(world.space, ConnectAccess(world.space));
  }
  Motion motion() const {
    const Twist& twist = world.twist(footbot);
    return {twist.linear.head<2>(), twist.angular.z()};
  }

  World world;
  Row footbot = kNoRow;

 private:
  void set(Row row, const Vector2d& velocity, double turn_rate) {
    Twist& twist = world.space.entities.twist[row];
    twist.linear = {velocity.x(), velocity.y(), 0.0};
    twist.angular = {0.0, 0.0, turn_rate};
  }
};

/// Whether the robot holds a prey, its turn rate [rad/s], and the commanded speed and turn rate.
struct SlipCase {
  bool holds;
  double turn_rate;
  double commanded_speed;
  double commanded_turn;
};

class SlipDirectionTest : public testing::TestWithParam<SlipCase> {};

TEST_P(SlipDirectionTest, TreelsAreHeldBackAgainstTheirSlip) {
  const SlipCase& given = GetParam();
  constexpr double kHeading = 0.37;
  constexpr double kTreelForce = 0.5 * kTreelFriction * kMass * kGravity;
  constexpr std::chrono::microseconds kTick(100);
  const double dt = 1e-6 * static_cast<double>(kTick.count());
  for (int k = 0; k < 16; ++k) {
    const Motion before{0.8 * along(direction(k)), given.turn_rate};
    const Motion commanded{given.commanded_speed * along(kHeading), given.commanded_turn};
    Vector2d force = Vector2d::Zero();
    double torque = 0.0;
    for (const double side : {1.0, -1.0}) {
      const Vector2d arm = side * kHalfTrack * along(kHeading + M_PI / 2.0);
      const Vector2d friction = -kTreelForce * (before.at(arm) - commanded.at(arm)).normalized();
      force += friction;
      torque += planar::cross(arm, friction);
    }
    Slider slider(kHeading, before, given.holds, 1);
    slider.world.drive(slider.footbot, given.commanded_speed, given.commanded_turn);
    slider.tick(kTick);
    const Motion after = slider.motion();
    const Vector2d felt = kMass / dt * (after.velocity - before.velocity);
    const double turned = footbotModel()->inertia(2, 2) / dt * (after.turn_rate - before.turn_rate);
    EXPECT_LT(angleBetween(felt, force), kDegree) << "direction " << k;
    EXPECT_NEAR(felt.norm(), force.norm(), 0.03 * force.norm()) << "direction " << k;
    EXPECT_NEAR(turned, torque, 0.03 * 2.0 * kTreelForce * kHalfTrack) << "direction " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(Drives, SlipDirectionTest,
                         testing::Values(SlipCase{false, 0.0, 0.0, 0.0}, SlipCase{false, 2.3, 0.0, 0.0},
                                         SlipCase{false, -3.1, 0.21, 0.7}, SlipCase{true, 0.0, 0.0, 0.0},
                                         SlipCase{true, 2.3, 0.0, 0.0}, SlipCase{true, -3.1, 0.21, 0.7}));

TEST(BrakingTest, AFootbotSlidesStraightAndAsFarAsCoulombSays) {
  constexpr double kSpeed = 0.9;
  const double expected = kSpeed * kSpeed / (2.0 * kTreelFriction * kGravity);
  for (const bool holds : {false, true}) {
    for (int k = 0; k < 16; ++k) {
      Slider slider(0.37, {kSpeed * along(direction(k)), 0.0}, holds, 100);
      slider.tick(std::chrono::milliseconds(200));
      const Vector2d way = (slider.world.pose(slider.footbot).position - Vector3d(5.0, 5.0, 0.0)).head<2>();
      EXPECT_NEAR(way.norm(), expected, 0.03 * expected) << k << (holds ? " holding" : "");
      EXPECT_LT(angleBetween(way, along(direction(k))), kDegree) << k << (holds ? " holding" : "");
      EXPECT_NEAR(headingOf(slider.world.pose(slider.footbot)), 0.37, 0.01) << k << (holds ? " holding" : "");
      EXPECT_LT(slider.motion().velocity.norm(), 1e-4);
    }
  }
}

TEST(WallSlipTest, ADiscGoesAlongASmoothWallWithTheSpeedAlongIt) {
  // the treels slip straight towards the wall, and nothing holds the disc back along it
  for (const int subclock : {1, 4, 10}) {
    for (const double heading : {0.645, -0.645, 1.1}) {
      World world = worldWith({{"contact_friction", "0"}}, subclock);
      world.addBlock({0.1, 8.0, 0.5}, {2.0, 4.0, 0.25});
      const Row row = world.addRobot(discModel(0.1, 0.15), flatPose(1.95 - 0.1, 4.0, heading));
      world.drive(row, 0.17);
      world.step(40);
      const double expected = 4.0 * 0.17 * std::sin(heading);
      EXPECT_NEAR(world.pose(row).position.y() - 4.0, expected, 0.02 * std::abs(expected)) << subclock;
      EXPECT_NEAR(headingOf(world.pose(row)), heading, 0.02) << subclock;
    }
  }
}

TEST(PullTest, TenPullAsFastAsTheirTreelsAndThePreyAgree) {
  // each pulls along its own heading and is dragged aside by the others: the forward forces of all treels equal the
  // friction of the prey on the ground
  constexpr double kTold = 0.1;  // m/s
  constexpr double kReach = 0.915;
  constexpr double kPreyMass = 20.0;
  std::vector<double> angles;
  for (int i = 0; i < 10; ++i) {
    angles.push_back((i - 4.5) * 0.25);
  }
  const auto pushAhead = [&](double speed) {
    double sum = 0.0;
    for (const double angle : angles) {
      const Vector2d slip = Vector2d(speed, 0.0) - kTold * along(angle);
      sum -= kTreelFriction * kMass * kGravity * slip.x() / slip.norm();
    }
    return sum;
  };
  double low = 0.0;
  double high = kTold;
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    (pushAhead(middle) > 0.4 * kPreyMass * kGravity ? low : high) = middle;
  }
  World world({10.0, 10.0, 2.0}, 10);
  const Row prey = world.addPrey(0.8, 0.1, 3.0, 5.0, kPreyMass);
  for (const double angle : angles) {
    const Vector2d place = Vector2d(3.0, 5.0) + kReach * along(angle);
    const Row row = world.addFootbot(flatPose(place.x(), place.y(), angle + M_PI));
    world.setGripper(row, true);
    world.drive(row, -kTold);
  }
  world.step(20);
  const Vector3d start = world.pose(prey).position;
  world.step(60);
  ASSERT_EQ(world.space.structure.grippersOf(prey).size(), 10U);
  EXPECT_NEAR((world.pose(prey).position - start).x() / 6.0, low, 0.03 * low);
  EXPECT_NEAR((world.pose(prey).position - start).y(), 0.0, 5e-3);
}

TEST(SlidingTest, WhatHasItsCentreOfMassElsewhereSlidesStraight) {
  auto model = std::make_shared<EntityModel>(*cylindricPreyModel(0.1, 0.1, 0.7));
  model->centre_of_mass = {0.031, -0.017, 0.0};
  constexpr double kSpeed = 0.8;
  const double expected = kSpeed * kSpeed / (2.0 * 0.4 * kGravity);
  for (int k = 0; k < 16; ++k) {
    World world({10.0, 10.0, 2.0}, 100);
    const Row row = world.addToSpace(model, flatPose(5.0, 5.0, 0.37));
    const Vector2d velocity = kSpeed * along(direction(k));
    world.space.entities.twist[row].linear = {velocity.x(), velocity.y(), 0.0};
    test::carryOut(world.space);
    world.engine.add(world.space, row, Role::kMove);
    world.step(4);
    const Vector2d way = (world.pose(row).position - Vector3d(5.0, 5.0, 0.0)).head<2>();
    EXPECT_NEAR(way.norm(), expected, 0.03 * expected) << k;
    EXPECT_LT(angleBetween(way, velocity), kDegree) << k;
    EXPECT_NEAR(headingOf(world.pose(row)), 0.37, 1e-3) << k;
  }
}

TEST(SlidingTest, ADiscThatSpinsSlidesFartherAndOneThatSlidesSpinsLonger) {
  // Coulomb friction on rings and angles of an evenly loaded disc, integrated here; both motions end at the same time
  constexpr double kRadius = 0.1;
  for (const auto& [speed, turn_rate] :
       {std::pair{0.8, 0.0}, std::pair{0.0, 5.0}, std::pair{0.8, 5.0}, std::pair{0.31, -17.0}, std::pair{0.55, 9.3}}) {
    double v = speed;
    double w = turn_rate;
    double way = 0.0;
    double turn = 0.0;
    constexpr double kFine = 1e-4;
    while (v > 1e-3 || std::abs(w) > 1e-2) {
      double force = 0.0;
      double torque = 0.0;
      constexpr int kRingCount = 12;
      constexpr int kAround = 24;
      for (int ring = 0; ring < kRingCount; ++ring) {
        const double r = kRadius * std::sqrt((ring + 0.5) / kRingCount);  // rings of equal areas
        for (int k = 0; k < kAround; ++k) {
          const double angle = 2.0 * M_PI * (k + 0.5) / kAround;
          const Vector2d slip(v - w * r * std::sin(angle), w * r * std::cos(angle));
          const Vector2d friction = -0.4 * kGravity / (kRingCount * kAround) * slip / std::max(slip.norm(), 1e-9);
          force += friction.x();
          torque += r * (std::cos(angle) * friction.y() - std::sin(angle) * friction.x());
        }
      }
      v = std::max(0.0, v + kFine * force);
      w += kFine * torque / (0.5 * kRadius * kRadius);
      way += kFine * v;
      turn += kFine * w;
    }
    World world({10.0, 10.0, 2.0}, 100);
    const Row row = world.addToSpace(cylindricPreyModel(kRadius, 0.1, 0.7), flatPose(5.0, 5.0));
    Twist& twist = world.space.entities.twist[row];
    twist.linear.x() = speed;
    twist.angular.z() = turn_rate;
    test::carryOut(world.space);
    world.engine.add(world.space, row, Role::kMove);
    world.step(10);
    EXPECT_NEAR(world.pose(row).position.x() - 5.0, way, 0.01 * way + 1e-3) << speed << " " << turn_rate;
    EXPECT_NEAR(std::remainder(headingOf(world.pose(row)) - turn, 2.0 * M_PI), 0.0, 0.01 * std::abs(turn) + 0.01);
  }
}

TEST(CoulombTest, TheFrictionIsTheLargestAgainstTheSlipThatRemains) {
  Eigen::Matrix2d yield;
  yield << 1.9, 0.35, 0.35, 0.6;
  for (int k = 0; k < 16; ++k) {
    for (const double most : {0.01, 0.2, 0.7, 5.0}) {
      const Vector2d slip = 0.83 * along(direction(k));
      const Vector2d friction = coulombFriction(yield, slip, most);
      const Vector2d remaining = slip + yield * friction;
      EXPECT_LE(friction.norm(), most * (1.0 + 1e-8));
      if (friction.norm() < most * (1.0 - 1e-8)) {
        EXPECT_LT(remaining.norm(), 1e-12) << "it sticks";
      } else {
        EXPECT_LT(angleBetween(-friction, remaining), 1e-5) << k << " " << most;
      }
    }
  }
  EXPECT_EQ(coulombFriction(yield, {0.3, 0.1}, 0.0), Vector2d(0.0, 0.0));
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
