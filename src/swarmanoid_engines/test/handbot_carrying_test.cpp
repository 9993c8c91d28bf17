// Two footbots grip the strip of a handbot, one on each side, with turrets turned towards it, and carry it, in each
// engine.
#include <gtest/gtest.h>

#include "dynamics2d/world.hpp"
#include "dynamics3d/world.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid {
namespace {

using Eigen::Vector3d;

constexpr double kHeading = 0.83;  // rad, of the handbot
constexpr double kAskew = 0.29;    // rad, between the headings of the footbots and that of the handbot, to the left
constexpr double kApart =
    0.265;  // m, between the axes of a footbot and of the handbot: the strip's radius, the tip, 1 cm

Pose poseAt(const Vector3d& position, double heading) {
  return {position, Eigen::Quaterniond(Eigen::AngleAxisd(heading, Vector3d::UnitZ()))};
}

double headingIn(const Pose& pose) { return 2.0 * std::atan2(pose.orientation.z(), pose.orientation.w()); }

/// A handbot between two footbots that have gripped it.
template <class World>
struct Carried {
  Carried() {
    handbot = world.add(robotModel("handbot"), poseAt({2.0, 2.0, 0.0}, kHeading));
    for (const double side : {1.0, -1.0}) {
      const double bearing = kHeading + side * M_PI_2;
      const Vector3d place(2.0 + kApart * std::cos(bearing), 2.0 + kApart * std::sin(bearing), 0.0);
      footbots.push_back(world.addTurret(poseAt(place, kHeading + kAskew)));
      world.turret(footbots.back()).holdAngle(-side * M_PI_2 - kAskew);
    }
    world.step(10);  // 1.86 rad at 3 rad/s
    for (const Row footbot : footbots) {
      world.setGripper(footbot, true);
    }
    world.step(5);
    begin = world.pose(handbot).position;
  }

  void drive(double left, double right) {
    world.drive(footbots[0], left);
    world.drive(footbots[1], right);
  }
  Vector3d way() const { return world.pose(handbot).position - begin; }
  static Vector3d ahead(double distance) {
    return {distance * std::cos(kHeading + kAskew), distance * std::sin(kHeading + kAskew), 0.0};
  }

  World world;
  Row handbot = kNoRow;
  std::vector<Row> footbots;
  Vector3d begin;
};

template <class World>
class HandbotCarryingTest : public testing::Test {};

using Worlds = testing::Types<kinematics2d::World, dynamics2d::World, dynamics3d::World>;
TYPED_TEST_SUITE(HandbotCarryingTest, Worlds);

TYPED_TEST(HandbotCarryingTest, ItGoesWhereTwoFootbotsGo) {
  Carried<TypeParam> carried;
  TypeParam& world = carried.world;
  ASSERT_EQ(world.space.structure.grippersOf(carried.handbot).size(), 2U);
  carried.drive(0.07, 0.07);
  world.step(43);
  // 0.07 m/s for 4.3 s; motors of dynamics3d take 0.07 / 3 s to reach that speed, which costs 0.8 mm
  EXPECT_LT((carried.way() - carried.ahead(0.301)).norm(), 2e-3) << carried.way().transpose();
  EXPECT_NEAR(headingIn(world.pose(carried.handbot)), kHeading, 5e-3);
  EXPECT_EQ(world.space.structure.grippersOf(carried.handbot).size(), 2U);
}

TYPED_TEST(HandbotCarryingTest, WhoLetsGoLeavesItBehind) {
  Carried<TypeParam> carried;
  TypeParam& world = carried.world;
  for (const Row footbot : carried.footbots) {
    world.setGripper(footbot, false);
  }
  world.step();
  EXPECT_TRUE(world.space.structure.grippersOf(carried.handbot).empty());
  const Vector3d footbot = world.pose(carried.footbots[0]).position;
  carried.drive(0.07, -0.07);  // away from it, because of their headings
  world.step(10);
  EXPECT_LT(carried.way().norm(), 1e-3);
  EXPECT_NEAR((world.pose(carried.footbots[0]).position - footbot).norm(), 0.07, 2e-3);
}

TEST(KinematicCarryingTest, ItGoesTheMeanOfTheWaysAndKeepsItsPlace) {
  Carried<kinematics2d::World> carried;
  kinematics2d::World& world = carried.world;
  const auto place = [&](Row footbot) {
    const Pose& pose = world.pose(footbot);
    return Vector3d(pose.orientation.conjugate() * (world.pose(carried.handbot).position - pose.position));
  };
  const Vector3d left = place(carried.footbots[0]);
  const Vector3d right = place(carried.footbots[1]);
  carried.drive(0.11, 0.04);
  world.step(20);
  EXPECT_LT((carried.way() - carried.ahead(2.0 * 0.075)).norm(), 1e-12);
  EXPECT_NEAR(world.twist(carried.footbots[1]).linear.norm(), 0.075, 1e-12);
  world.drive(carried.footbots[0], 0.05, 0.36);  // a turn by one of them makes both turn half as much
  world.drive(carried.footbots[1], 0.05);
  world.step(100);
  EXPECT_NEAR(std::remainder(headingIn(world.pose(carried.handbot)) - kHeading - 1.8, 2.0 * M_PI), 0.0, 1e-12);
  EXPECT_LT((place(carried.footbots[0]) - left).norm(), 1e-13);
  EXPECT_LT((place(carried.footbots[1]) - right).norm(), 1e-13);
}

TEST(KinematicCarryingTest, WhoIsInTheWayOfOneStopsAll) {
  Carried<kinematics2d::World> carried;
  kinematics2d::World& world = carried.world;
  // its near face is 0.2 m ahead of the left footbot's front, far beside the handbot
  const Vector3d left = world.pose(carried.footbots[0]).position;
  const double heading = kHeading + kAskew;
  const Vector3d wall = left + (0.085 + 0.2 + 0.05) * Vector3d(std::cos(heading), std::sin(heading), 0.0);
  world.addBlock({0.1, 0.1, 0.2}, {wall.x(), wall.y(), 0.1}, heading);
  carried.drive(0.1, 0.1);
  world.step(50);
  EXPECT_NEAR(carried.way().norm(), 0.2, 0.01 / 16.0) << "a step of 1 cm, less than a 16th of it";
  EXPECT_LE(carried.way().norm(), 0.2);
  carried.drive(-0.1, -0.1);
  world.step(20);
  EXPECT_LT(carried.way().norm(), 0.01 / 16.0) << "back where it was";
}

TEST(KinematicCarryingTest, WhoSwingsAroundItJumpsThroughNoThinWall) {
  Carried<kinematics2d::World> carried;
  kinematics2d::World& world = carried.world;
  // a wall of 2 cm across the circle of the left footbot, 0.6 rad on; without it both would swing 1.2 rad in a tick
  constexpr double kAhead = 0.6;  // rad
  const double bearing = kHeading + M_PI_2 + kAhead;
  world.addBlock({0.1, 0.02, 0.2}, {2.0 + kApart * std::cos(bearing), 2.0 + kApart * std::sin(bearing), 0.1}, bearing);
  for (const Row footbot : carried.footbots) {
    world.drive(footbot, 0.0, 12.0);
  }
  world.step();
  // its side touches the footbot's, 0.085 m from the footbot's axis
  const double room = kAhead - std::asin((0.085 + 0.01) / kApart);
  const double turned = headingIn(world.pose(carried.handbot)) - kHeading;
  EXPECT_NEAR(turned, room, 0.15 / 16.0) << "a piece of 0.15 rad, less than a 16th of it";
  EXPECT_LE(turned, room + 1e-9);
}

TEST(KinematicCarryingTest, GripsOfSeveralComeAlongIntoTheEngine) {
  Carried<kinematics2d::World> carried;
  kinematics2d::World& world = carried.world;
  for (const Row footbot : carried.footbots) {
    EXPECT_EQ(world.engine.unsupportedStateReason(world.space, footbot), "");
  }
  const std::vector<Row> all{carried.footbots[1], carried.handbot, carried.footbots[0]};
  for (const Row row : all) {
    world.engine.remove(world.space, row);
  }
  for (const Row row : all) {
    test::carryOut(world.space);
    world.engine.add(world.space, row, Role::kMove);
  }
  carried.drive(0.06, 0.14);
  world.step(10);
  EXPECT_LT((carried.way() - carried.ahead(0.1)).norm(), 1e-12);
}

TEST(KinematicCarryingTest, TheOneThatStaysCarriesItAlone) {
  Carried<kinematics2d::World> carried;
  kinematics2d::World& world = carried.world;
  world.setGripper(carried.footbots[0], false);
  world.step();
  const Vector3d left = world.pose(carried.footbots[0]).position;
  carried.drive(0.0, -0.1);
  world.step(10);
  EXPECT_LT((carried.way() - carried.ahead(-0.1)).norm(), 1e-12);
  EXPECT_EQ(world.pose(carried.footbots[0]).position, left);
  world.remove(carried.footbots[1]);
  world.step();
  EXPECT_TRUE(world.space.structure.grippersOf(carried.handbot).empty());
}

}  // namespace
}  // namespace swarmanoid
