// Pushed and pulled loads against hand computations: Coulomb's law on each element of a load's support, slow enough
// that masses do not matter. The hand computations are sums over fine grids, independent of the engine.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "world.hpp"

namespace swarmanoid::dynamics2d {
namespace {

using Eigen::Vector2d;

constexpr double kBackRadius = 0.085;  // m, of a footbot
constexpr double kTip = 0.11;          // m, of its gripper

/// A zero of a function that changes its sign.
double root(const std::function<double(double)>& function, double low, double high) {
  const bool starts_positive = function(low) > 0.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    ((function(middle) > 0.0) == starts_positive ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The moment about `about` of friction on evenly loaded points that turn about `pole`, in units of mu m g.
double frictionMoment(const std::vector<Vector2d>& points, const Vector2d& pole, const Vector2d& about) {
  double sum = 0.0;
  for (const Vector2d& point : points) {
    const Vector2d way = point - pole;
    const Vector2d friction = Vector2d(way.y(), -way.x()) / std::max(way.norm(), 1e-12);
    sum += planar::cross(point - about, friction) / static_cast<double>(points.size());
  }
  return sum;
}

std::vector<Vector2d> rectangle(double length, double width) {
  std::vector<Vector2d> points;
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 60; ++k) {
      points.emplace_back(length * ((i + 0.5) / 20 - 0.5), width * ((k + 0.5) / 60 - 0.5));
    }
  }
  return points;
}

std::vector<Vector2d> disc(double radius) {
  std::vector<Vector2d> points;
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 60; ++k) {
      const Vector2d point = radius * Vector2d((i + 0.5) / 30 - 1.0, (k + 0.5) / 30 - 1.0);
      if (point.norm() < radius) {
        points.push_back(point);
      }
    }
  }
  return points;
}

struct Moved {
  double turn;  // rad
  double way;   // m, along the push
};

/// A block that a smooth round pusher shifts along x. The force is along the normal of the pushed side, so by symmetry
/// the block turns about a point of the line through its middle along that side: the point at which friction has no
/// moment about the contact.
/// @param points points that carry the block, evenly
Moved pushBlock(const std::vector<Vector2d>& points, double length, double offset, double way) {
  constexpr int kSteps = 200;
  double heading = 0.0;
  Vector2d middle = Vector2d::Zero();
  Vector2d pusher(-0.5 * length - kBackRadius, offset);
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::Rotation2Dd turn(heading);
    const double contact = (turn.inverse() * (pusher - middle)).y();
    const Vector2d place(-0.5 * length, contact);
    const double side = contact > 0.0 ? -1.0 : 1.0;  // the pole is beyond the middle
    const double pole = root([&](double at) { return frictionMoment(points, {0.0, side * at}, place); }, 1e-6, 1e3);
    // speed of the contact along the normal: that of the pusher
    const double speed = (turn.inverse() * Vector2d::UnitX()).x();
    const double turn_rate = -speed / (contact - side * pole);
    const Vector2d velocity = turn_rate * Vector2d(side * pole, 0.0);
    middle += turn * velocity * (way / kSteps);
    heading += turn_rate * way / kSteps;
    pusher.x() += way / kSteps;
  }
  return {heading, middle.x()};
}

struct Steps {
  int tick_ms;
  int subclock;
};

template <class TestWorld>
void tick(TestWorld& world, int milliseconds) {
  test::carryOut(world.space);
  world.engine.readMirrors(world.space);
  world.engine.move(world.space, MoveAccess(world.space), std::chrono::milliseconds(milliseconds));
  world.engine.connect(world.space, ConnectAccess(world.space));
}

class OffCentrePushTest : public testing::TestWithParam<Steps> {
 protected:
  static constexpr double kWay = 0.2;  // m

  struct Case {
    double offset;   // m
    double heading;  // rad
    double mass;     // kg
  };
  /// Motion of a block of 0.2 m x 0.6 m pushed by a footbot's round back, in the block's frame before the push.
  static Moved push(const Case& given, const std::string& support) {
    constexpr double kGap = 1e-3;  // m
    constexpr double kSpeed = 0.058;
    World world({20.0, 20.0, 3.0}, GetParam().subclock, "z", 0.0, {{"contact_friction", "0"}, {"support", support}});
    const Eigen::Rotation2Dd turn(given.heading);
    const Vector2d start(10.0, 10.0);
    const Row block = world.add(blockModel({0.2, 0.6, 0.2}, given.mass), flatPose(10.0, 10.0, given.heading, 0.1));
    const Vector2d place = start + turn * Vector2d(-0.1 - kBackRadius - kGap, given.offset);
    const Row footbot = world.addFootbot(flatPose(place.x(), place.y(), given.heading + M_PI));
    world.drive(footbot, -kSpeed);
    const int ticks = static_cast<int>(std::lround((kWay + kGap) / kSpeed / (1e-3 * GetParam().tick_ms)));
    for (int i = 0; i < ticks; ++i) {
      tick(world, GetParam().tick_ms);
    }
    const Vector2d moved = turn.inverse() * (world.pose(block).position.head<2>() - start);
    return {std::remainder(headingOf(world.pose(block)) - given.heading, 2.0 * M_PI), moved.x()};
  }
  static void expectNear(const Moved& found, const Moved& expected, double offset) {
    EXPECT_NEAR(found.turn, expected.turn, 0.05 * std::abs(expected.turn)) << offset;
    EXPECT_NEAR(found.way, expected.way, 0.06 * expected.way) << offset;
  }
};

TEST_P(OffCentrePushTest, ABlockTurnsAsItsSupportAllows) {
  for (const Case& given : {Case{0.05, 0.0, 2.0}, Case{0.1, 0.71, 1.3}, Case{0.137, -2.2, 0.6}, Case{0.2, 3.0, 2.9},
                            Case{0.25, 1.3, 2.0}}) {
    expectNear(push(given, "even"), pushBlock(rectangle(0.2, 0.6), 0.2, given.offset, kWay), given.offset);
  }
}

TEST_P(OffCentrePushTest, ABlockOnItsCornersTurnsLess) {
  const std::vector<Vector2d> corners{{0.1, 0.3}, {-0.1, 0.3}, {-0.1, -0.3}, {0.1, -0.3}};
  for (const Case& given : {Case{0.05, 0.4, 2.0}, Case{0.11, -1.9, 0.8}, Case{0.23, 2.6, 1.7}}) {
    const Moved expected = pushBlock(corners, 0.2, given.offset, kWay);
    EXPECT_LT(std::abs(expected.turn), 0.8 * std::abs(pushBlock(rectangle(0.2, 0.6), 0.2, given.offset, kWay).turn));
    expectNear(push(given, "edge"), expected, given.offset);
  }
}

INSTANTIATE_TEST_SUITE_P(Steps, OffCentrePushTest,
                         testing::Values(Steps{5, 1}, Steps{50, 5}, Steps{100, 4}, Steps{50, 1}, Steps{100, 1}));

TEST(HandComputationTest, AgreesWithAnIntegrationMadeElsewhere) {
  const Moved expected = pushBlock(rectangle(0.2, 0.6), 0.2, 0.1, 0.2);
  EXPECT_NEAR(expected.turn, -0.575, 0.01);
  EXPECT_NEAR(expected.way, 0.144, 0.002);
}

TEST(DiscPushTest, ADiscRollsOffItsPusher) {
  // the contact sticks until its friction limit; values integrated by hand over an evenly loaded disc
  constexpr double kDegree = M_PI / 180.0;
  for (const double heading : {0.0, 0.9, -2.4}) {
    World world({30.0, 20.0, 3.0}, 10, "z", 0.0, {{"ground_friction", "0.5"}, {"contact_friction", "0.5"}});
    const Eigen::Rotation2Dd turn(heading);
    const Vector2d start(10.0, 10.0);
    const Vector2d place = start + turn * Vector2d(0.209998743710662, 0.03);
    const Row prey = world.addPrey(0.1, 0.1, place.x(), place.y(), 1.0);
    const Row footbot = world.addFootbot(flatPose(start.x(), start.y(), heading));
    world.drive(footbot, 0.058);
    const int ticks = static_cast<int>(std::lround(0.15 / 0.058 / 0.05));
    for (int i = 0; i < ticks; ++i) {
      tick(world, 50);
    }
    const Vector2d ahead = turn.inverse() * (world.pose(prey).position - world.pose(footbot).position).head<2>();
    const Vector2d corner(kTip, 0.02);
    const Vector2d normal = ahead - corner;
    EXPECT_NEAR(std::remainder(headingOf(world.pose(prey)), 2.0 * M_PI), 13.2 * kDegree, 0.05 * 13.2 * kDegree);
    EXPECT_NEAR(std::atan2(normal.y(), normal.x()), 18.9 * kDegree, 0.05 * 18.9 * kDegree);
  }
}

TEST(SwingTest, ATurretThatSwingsADiscFeelsTheFrictionOfEachElement) {
  // about the robot's centre: mu m g times the mean distance of the disc's elements from it
  constexpr double kArm = 0.22;  // m
  for (const double mass : {0.25, 0.6, 0.93}) {
    double mean = 0.0;
    const std::vector<Vector2d> points = disc(0.1);
    for (const Vector2d& point : points) {
      mean += (point + Vector2d(kArm, 0.0)).norm() / static_cast<double>(points.size());
    }
    const double expected = 0.4 * mass * kGravity * mean;
    World world({10.0, 10.0, 2.0}, 10);
    const Row footbot = world.addTurret(flatPose(2.0, 2.0, 0.4));
    world.addPrey(0.1, 0.12, 2.0 + kArm * std::cos(0.4), 2.0 + kArm * std::sin(0.4), mass);
    world.setGripper(footbot, true);
    world.step();
    world.turret(footbot).turnAt(0.5);
    world.step(15);
    EXPECT_NEAR(world.turretState(footbot).speed, 0.5, 1e-3);
    EXPECT_NEAR(world.turretState(footbot).effort, expected, 0.02 * expected) << mass;
  }
}

TEST(TrailingTest, ALoadBehindAPassiveTurretComesIntoLine) {
  // towed by a pin at the robot's centre, a disc turns so that friction has no moment about the pin
  constexpr double kArm = 0.22;  // m
  constexpr double kSpeed = 0.0435;
  constexpr double kStart = 0.928;  // rad between the arm and the way back
  const std::vector<Vector2d> points = disc(0.1);
  double expected = kStart;
  constexpr int kSteps = 200;
  const double way = 40 * 0.1 * kSpeed;
  for (int i = 0; i < kSteps; ++i) {
    const Vector2d arm = kArm * Vector2d(-std::cos(expected), std::sin(expected));
    std::vector<Vector2d> placed;
    for (const Vector2d& point : points) {
      placed.push_back(arm + point);
    }
    // the pin moves with 1 m/s along x: the pole is above or below it, and the load turns about that
    const double turn_rate = root(
        [&](double rate) {
          return frictionMoment(placed, {0.0, 1.0 / rate}, Vector2d::Zero());
        },
        1e-3, 30.0);
    expected -= turn_rate * way / kSteps;
  }
  World world({10.0, 10.0, 2.0}, 10);
  const Row footbot = world.addTurret(flatPose(5.0, 5.0, 0.0));
  world.turret(footbot).holdAngle(M_PI - kStart);
  world.step(20);
  const Row prey = world.addPrey(0.1, 0.12, 5.0 - kArm * std::cos(kStart), 5.0 + kArm * std::sin(kStart), 0.7);
  world.setGripper(footbot, true);
  world.step();
  ASSERT_EQ(world.space.structure.grippedBy(footbot), prey);
  world.turret(footbot).letTurn();
  world.drive(footbot, kSpeed);
  world.step(40);
  const Vector2d arm = (world.pose(prey).position - world.pose(footbot).position).head<2>();
  const double angle = std::atan2(arm.y(), -arm.x());
  EXPECT_NEAR(angle, expected, 0.05 * expected);
}

/// Footbots side by side that push a block.
class CrowdPushTest : public testing::TestWithParam<Steps> {
 protected:
  /// @return speed of the block in the last second [m/s]
  static double speedOf(int count, double share, double heading) {
    constexpr double kSpeed = 0.087;
    World world({20.0, 20.0, 3.0}, GetParam().subclock);
    const Eigen::Rotation2Dd turn(heading);
    const Vector2d start(10.0, 10.0);
    const double mass = share * count * 0.9 * 1.8 / 0.4;
    const Row block = world.add(blockModel({0.2, 0.2 * count + 0.1, 0.2}, mass), flatPose(10.0, 10.0, heading, 0.1));
    for (int i = 0; i < count; ++i) {
      const Vector2d place = start + turn * Vector2d(-0.1 - kTip - 1e-3, 0.2 * (i - 0.5 * (count - 1)));
      world.drive(world.addFootbot(flatPose(place.x(), place.y(), heading)), kSpeed);
    }
    const int ticks = 1000 / GetParam().tick_ms;
    Vector2d before = start;
    for (int i = 0; i < 3 * ticks; ++i) {
      before = i == 2 * ticks ? Vector2d(world.pose(block).position.head<2>()) : before;
      tick(world, GetParam().tick_ms);
    }
    return (world.pose(block).position.head<2>() - before).norm();
  }
};

TEST_P(CrowdPushTest, GoesAtFullSpeedBelowTheLimitAndStandsAbove) {
  for (const int count : {1, 2, 3, 5, 8, 12}) {
    for (const double share : {0.7, 0.8, 0.94, 0.97}) {
      EXPECT_NEAR(speedOf(count, share, 0.3 * count), 0.087, 3e-3) << count << " at " << share;
    }
    for (const double share : {1.03, 1.06, 1.3, 1.4}) {
      EXPECT_NEAR(speedOf(count, share, -0.4 * count), 0.0, 3e-3) << count << " at " << share;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Steps, CrowdPushTest,
                         testing::Values(Steps{5, 1}, Steps{100, 4}, Steps{50, 1}, Steps{100, 1}));

TEST(StartTest, AStartedPreyGoesTheSameWayInAllSteps) {
  // the robot starts half a millimetre before the prey; the friction of its treels accelerates it to 0.174 m/s
  for (const Steps& steps : {Steps{5, 1}, Steps{10, 1}, Steps{25, 1}, Steps{50, 1}, Steps{100, 4}, Steps{100, 1}}) {
    constexpr double kSpeed = 0.174;
    constexpr double kMass = 0.3;
    World world({10.0, 10.0, 2.0}, steps.subclock);
    const Row footbot = world.addFootbot(flatPose(2.0, 2.0));
    const Row prey = world.addPrey(0.1, 0.12, 2.0 + kTip + 0.1 + 5e-4, 2.0, kMass);
    world.drive(footbot, kSpeed);
    for (int i = 0; i < 300 / steps.tick_ms; ++i) {
      tick(world, steps.tick_ms);
    }
    // from the contact on, treels push both against the prey's friction
    const double alone = 0.9 * kGravity;
    const double met = std::sqrt(2.0 * alone * 5e-4);
    const double together = 1.8 / (1.8 + kMass) * met;
    const double pushed = (0.9 * 1.8 - 0.4 * kMass) * kGravity / (1.8 + kMass);
    const double time = (kSpeed - together) / pushed;
    const double expected = 0.5 * (together + kSpeed) * time + kSpeed * (0.3 - met / alone - time);
    EXPECT_NEAR(world.pose(prey).position.x() - 2.2105, expected, 0.06 * expected) << steps.tick_ms;
  }
}

}  // namespace
}  // namespace swarmanoid::dynamics2d
