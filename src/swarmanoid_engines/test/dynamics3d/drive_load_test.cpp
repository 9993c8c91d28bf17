// Friction of contacts whose load comes from a robot's own drive: walls, squeezed blocks, pushed discs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <ostream>

#include "../turned_frame.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kDriveSpeed = 0.2;                  // m/s, commanded
constexpr double kSlipForce = 0.9 * 1.8 * kGravity;  // N, of a footbot whose treels slip

struct WallCase {
  double friction;
  double degrees;  // heading, from the wall's normal
  double turn;     // of the world [rad]
  const char* subclock;
};

void PrintTo(const WallCase& values, std::ostream* out) {
  *out << "friction " << values.friction << ", " << values.degrees << " degrees, " << values.subclock << " steps";
}

class WallTest : public testing::TestWithParam<WallCase> {};

TEST_P(WallTest, AlongAWallARobotIsAsFastAsFrictionLetsIt) {
  // By hand: with the heading `a` from the wall's normal, treels slip by v cos a towards the wall and by v sin a - s
  // along it, where s is the speed along the wall. Their friction opposes that slip and alone balances the wall's load
  // and friction, whose ratio is 1 : mu. So v sin a - s = mu v cos a.
  const WallCase& values = GetParam();
  for (const char* solver : {"exact", "iterative"}) {
    World world({{"friction", std::to_string(values.friction)}, {"subclock", values.subclock}, {"solver", solver}});
    const TurnedFrame turned(values.turn);
    world.addBlock({0.1, 8.0, 0.5}, 0.0, turned.at(0.05, 0.0, 0.0, 0.25));
    const Row footbot = world.addFootbot(turned.at(-0.12, -1.0, values.degrees * kDegree));
    world.drive(footbot, kDriveSpeed);
    world.step(20);
    const double before = turned.heading(world.pose(footbot));
    const Vector3d start = turned.back(world.pose(footbot).position);
    world.step(20);
    const double heading = 0.5 * (before + turned.heading(world.pose(footbot)));
    const double expected = kDriveSpeed * (std::sin(heading) - values.friction * std::cos(heading));
    const double found = (turned.back(world.pose(footbot).position).y() - start.y()) / 2.0;
    EXPECT_NEAR(found, expected, 0.03 * expected) << solver;
    EXPECT_GT(expected, 0.05) << "too slow to say anything";
  }
}

INSTANTIATE_TEST_SUITE_P(Three, WallTest,
                         testing::Values(WallCase{0.3, 60.0, 0.29, "10"}, WallCase{0.6, 66.0, 1.13, "14"},
                                         WallCase{0.41, 71.0, 2.6, "20"}));

class RoughWallTest : public testing::TestWithParam<WallCase> {};

TEST_P(RoughWallTest, WhatBacksIntoARoughWallRollsStraightAndStands) {
  // By hand: friction on the wall turns the robot until it stands straight, and tan 0 < mu: it stands.
  const WallCase& values = GetParam();
  World world({{"friction", std::to_string(values.friction)}, {"subclock", values.subclock}});
  const TurnedFrame turned(values.turn);
  world.addBlock({0.1, 8.0, 0.5}, 0.0, turned.at(0.05, 0.0, 0.0, 0.25));
  const Row footbot = world.addFootbot(turned.at(-0.09, -1.0, M_PI + values.degrees * kDegree));
  world.drive(footbot, -kDriveSpeed);
  world.step(50);
  const Vector3d start = world.pose(footbot).position;
  world.step(10);
  EXPECT_LT((world.pose(footbot).position - start).norm(), 1e-3);
  EXPECT_NEAR(std::remainder(turned.heading(world.pose(footbot)) - M_PI, 2.0 * M_PI), 0.0, 0.5 * kDegree);
}

INSTANTIATE_TEST_SUITE_P(Three, RoughWallTest,
                         testing::Values(WallCase{0.3, 30.0, 0.0, "10"}, WallCase{0.37, -24.0, 0.83, "13"},
                                         WallCase{0.52, 35.0, 2.2, "20"}));

class SmoothWallTest : public testing::TestWithParam<WallCase> {};

TEST_P(SmoothWallTest, WhatBacksIntoASmoothWallKeepsItsHeading) {
  // By hand: all treels slip in one direction u, so their torque is mu (sum of N r) x u. The sum of N r is the tipping
  // moment of the wall's force, which is along u: there is no torque. The remaining turn, up to 2.3 degrees in 10 s,
  // has no explanation yet.
  const WallCase& values = GetParam();
  World world({{"friction", "0"}, {"subclock", values.subclock}});
  const TurnedFrame turned(values.turn);
  world.addBlock({0.1, 8.0, 0.5}, 0.0, turned.at(0.05, 0.0, 0.0, 0.25));
  const Row footbot = world.addFootbot(turned.at(-0.09, -1.0, M_PI + values.degrees * kDegree));
  world.drive(footbot, -kDriveSpeed);
  world.step(100);
  const double turn = std::remainder(turned.heading(world.pose(footbot)) - M_PI, 2.0 * M_PI) / kDegree;
  EXPECT_NEAR(turn, values.degrees, 3.0);
}

INSTANTIATE_TEST_SUITE_P(Three, SmoothWallTest,
                         testing::Values(WallCase{0.0, 1.0, 0.0, "10"}, WallCase{0.0, -1.7, 0.83, "16"},
                                         WallCase{0.0, 1.3, 2.2, "40"}));

struct SqueezeCase {
  double friction;
  double mass;  // kg
  double turn;
  const char* subclock;
};

void PrintTo(const SqueezeCase& values, std::ostream* out) { *out << values.friction << ", " << values.mass << " kg"; }

class SqueezeTest : public testing::TestWithParam<SqueezeCase> {
 protected:
  /// One footbot presses a block to a wall, another pushes it along. @return displacement of the block [m]
  static double wayAlong(bool is_pressed) {
    const SqueezeCase& values = GetParam();
    World world({{"friction", std::to_string(values.friction)}, {"subclock", values.subclock}});
    const TurnedFrame turned(values.turn);
    world.addBlock({0.1, 6.0, 0.5}, 0.0, turned.at(0.05, 0.0, 0.0, 0.25));
    const Row block = world.addBlock({0.2, 0.2, 0.2}, values.mass, turned.at(-0.1005, 0.0, 0.0, 0.1));
    const Row presser = world.addFootbot(turned.at(-0.32, 0.0, 0.0));
    const Row pusher = world.addFootbot(turned.at(-0.1, -0.215, 0.5 * M_PI));
    if (is_pressed) {
      world.drive(presser, 0.1);
      world.step(15);
    } else {
      world.place(presser, turned.at(-1.5, 0.0, 0.0));
    }
    world.drive(pusher, 0.08);
    world.step(30);
    return turned.back(world.pose(block).position).y();
  }
};

TEST_P(SqueezeTest, APressedBlockStaysWhereFrictionHoldsIt) {
  // By hand: the ground holds mu m g and the wall mu times the force of the presser. Together that exceeds the force of
  // the pusher; the ground alone holds less.
  const SqueezeCase& values = GetParam();
  const double on_ground = values.friction * values.mass * kGravity;
  ASSERT_LT(on_ground, 0.95 * kSlipForce);
  ASSERT_GT(on_ground + values.friction * kSlipForce, 1.1 * kSlipForce);
  EXPECT_LT(wayAlong(true), 2e-3);
  EXPECT_GT(wayAlong(false), 0.1);
}

INSTANTIATE_TEST_SUITE_P(Three, SqueezeTest,
                         testing::Values(SqueezeCase{0.8, 1.0, 0.4, "10"}, SqueezeCase{0.57, 2.3, 1.9, "14"},
                                         SqueezeCase{0.49, 3.1, 2.7, "20"}));

/// A disc on the rim of its foot, pushed in x by the corner of a gripper, so slowly that in each small step the forces
/// on it are in balance. The corner sticks to it, which the friction between them allows here.
struct SlowDisc {
  double radius;
  double tip_over;  // shift of the load ahead by the push [m]: mu x height of the push
  double side;      // of the disc's centre, beside the corner [m]
  double turn = 0.0;

  /// Force on the ground and torque about the centre, for mu m g = 1.
  Vector3d frictionOf(const Vector3d& motion, const Vector3d& ahead) const {
    constexpr int kPoints = 32;
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < kPoints; ++i) {
      const double at = 2.0 * M_PI * (i + 0.5) / kPoints;
      const Vector3d arm(radius * std::cos(at), radius * std::sin(at), 0.0);
      const Vector3d slip(motion.x() - motion.z() * arm.y(), motion.y() + motion.z() * arm.x(), 0.0);
      const double load = (1.0 + 2.0 * tip_over / radius * ahead.dot(arm) / radius) / kPoints;
      const Vector3d force = -load * slip / std::hypot(slip.norm(), 1e-9);
      sum += Vector3d(force.x(), force.y(), arm.x() * force.y() - arm.y() * force.x());
    }
    return sum;
  }

  /// Pushes the disc by a distance.
  void push(double way) {
    constexpr int kSteps = 300;
    for (int i = 0; i < kSteps; ++i) {
      // the turn rate follows from the balance of torques about the corner: by bisection
      const double along = std::sqrt(radius * radius - side * side);
      const auto torque = [&](double rate) {
        const Vector3d motion(1.0 + rate * -side, rate * along, rate);
        Vector3d ahead = -frictionOf(motion, Vector3d::Zero());
        ahead.z() = 0.0;
        const Vector3d force = frictionOf(motion, ahead.normalized());
        return force.z() + along * force.y() - side * force.x();
      };
      double low = 0.0;
      double high = 20.0;
      for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (low + high);
        (torque(middle) > 0.0 ? low : high) = middle;
      }
      const double step = way / kSteps;
      side += low * along * step;
      turn += low * step;
    }
  }
};

struct DiscCase {
  double radius;
  double mass;    // kg
  double offset;  // of its centre from the robot's axis [m]
  double turn;
  const char* subclock;
};

void PrintTo(const DiscCase& values, std::ostream* out) {
  *out << values.radius << " m, " << values.offset << " m aside";
}

class DiscTest : public testing::TestWithParam<DiscCase> {};

TEST_P(DiscTest, ADiscThatIsPushedOffCentreTurns) {
  constexpr double kWay = 0.15;  // m
  constexpr double kFriction = 0.5;
  constexpr double kFront = 0.11;   // m, ahead of a footbot's axis
  constexpr double kCorner = 0.02;  // m, beside it
  constexpr double kLow = 0.035;    // m, of the gripper's lower edge
  constexpr double kHigh = 0.065;   // m, of its upper edge
  const DiscCase& values = GetParam();
  World world({{"friction", std::to_string(kFriction)}, {"subclock", values.subclock}});
  world.space.clocktick = std::chrono::milliseconds(50);
  const TurnedFrame turned(values.turn);
  const double side = values.offset - kCorner;
  const double ahead = kFront + std::sqrt(values.radius * values.radius - side * side);
  const Row disc = world.add(cylindricPreyModel(values.radius, 0.1, values.mass), turned.at(ahead, values.offset, 0.0));
  const Row footbot = world.addFootbot(turned.at(-1e-4, 0.0, 0.0));
  world.drive(footbot, 0.06);
  while (turned.back(world.pose(footbot).position).x() < kWay) {
    world.step();
  }
  // with rigid bodies, the height at which the gripper's face pushes is undetermined
  SlowDisc low{values.radius, kFriction * kLow, side};
  SlowDisc high{values.radius, kFriction * kHigh, side};
  low.push(turned.back(world.pose(footbot).position).x());
  high.push(turned.back(world.pose(footbot).position).x());
  const Vector3d apart = turned.back(world.pose(disc).position) - turned.back(world.pose(footbot).position);
  const double normal = std::asin((apart.y() - kCorner) / values.radius);
  EXPECT_LT(normal, 1.02 * std::asin(low.side / values.radius));
  EXPECT_GT(normal, 0.98 * std::asin(high.side / values.radius));
  const double spin = turned.heading(world.pose(disc));
  EXPECT_LT(spin, 1.05 * low.turn);
  EXPECT_GT(spin, 0.95 * high.turn);
}

INSTANTIATE_TEST_SUITE_P(Three, DiscTest,
                         testing::Values(DiscCase{0.1, 1.0, 0.03, 0.0, "10"}, DiscCase{0.16, 0.7, 0.045, 0.83, "6"},
                                         DiscCase{0.21, 1.3, 0.038, 2.2, "8"}));

}  // namespace
}  // namespace swarmanoid::dynamics3d
