// Turrets without forces: they turn as commanded, with the gripped body, and never into an obstacle.
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

#include <gtest/gtest.h>

#include <tuple>
#include <vector>

#include "turret_models.hpp"
#include "world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

using Eigen::Vector3d;

/// A footbot with a turret at (2, 2), closed on a prey whose centre is kArm ahead.
struct Holder {
  static constexpr double kArm = 0.22;  // m

  explicit Holder(int subclock = 1) : world({10.0, 10.0, 2.0}, subclock) {
    footbot = world.addTurret(flatPose(2.0, 2.0));
    prey = world.addPrey(0.1, 0.12, 2.0 + kArm, 2.0);
    world.setGripper(footbot, true);
    world.step();
  }
  FootbotTurret& turret() { return world.turret(footbot); }
  double angle() const { return world.turretState(footbot).angle; }
  Vector3d way() const { return world.pose(prey).position - world.pose(footbot).position; }
  /// Direction from the footbot to the prey, in W.
  double bearing() const { return std::atan2(way().y(), way().x()); }

  World world;
  Row footbot = kNoRow;
  Row prey = kNoRow;
};

TEST(TurretTest, TurnsToAnAngleInTheTimeThatItsSpeedTakes) {
  for (const int subclock : {1, 5}) {
    World world({10.0, 10.0, 2.0}, subclock);
    const Row footbot = world.addTurret(flatPose(2.0, 2.0));
    world.step();
    EXPECT_EQ(world.turretState(footbot).angle, 0.0);
    world.turret(footbot).holdAngle(2.0);
    world.step(6);
    EXPECT_NEAR(world.turretState(footbot).angle, 6 * 0.1 * kTurretSpeed, 1e-12);
    EXPECT_NEAR(world.turretState(footbot).speed, kTurretSpeed, 1e-12);
    world.step();
    EXPECT_EQ(world.turretState(footbot).angle, 2.0);
    EXPECT_NEAR(world.turretState(footbot).speed, 2.0, 1e-9);  // mean speed of the tick for the rest of the way
    world.step();
    EXPECT_EQ(world.turretState(footbot).angle, 2.0);
    EXPECT_EQ(world.turretState(footbot).speed, 0.0);
    EXPECT_EQ(world.turretState(footbot).effort, 0.0);
    EXPECT_EQ(world.pose(footbot).position, Vector3d(2.0, 2.0, 0.0));
  }
}

TEST(TurretTest, TurnsTheShorterWay) {
  World world;
  const Row footbot = world.addTurret(flatPose(2.0, 2.0));
  world.turret(footbot).holdAngle(3.0);
  world.step(11);
  EXPECT_EQ(world.turretState(footbot).angle, 3.0);
  world.turret(footbot).holdAngle(-3.0);
  world.step();
  EXPECT_EQ(world.turretState(footbot).angle, -3.0);
  EXPECT_NEAR(world.turretState(footbot).speed, (2.0 * M_PI - 6.0) / 0.1, 1e-9);
}

TEST(TurretTest, TurnsOnAtASpeedUpToItsLimit) {
  for (const auto& [commanded, expected] :
       {std::pair(1.5, 1.5), std::pair(-1.5, -1.5), std::pair(50.0, kTurretSpeed)}) {
    World world;
    const Row footbot = world.addTurret(flatPose(2.0, 2.0));
    world.turret(footbot).turnAt(commanded);
    world.step(100);
    EXPECT_NEAR(world.turretState(footbot).speed, expected, 1e-9);
    EXPECT_NEAR(std::remainder(world.turretState(footbot).angle - 10.0 * expected, 2.0 * M_PI), 0.0, 1e-9);
    EXPECT_LE(std::abs(world.turretState(footbot).angle), M_PI);
  }
}

TEST(TurretTest, RaysHitTheGripperWhereItWasTurned) {
  World world;
  const Row footbot = world.addTurret(flatPose(2.0, 2.0));
  world.turret(footbot).holdAngle(M_PI / 2.0);
  world.step(6);
  const double left = world.castRay({2.0, 3.0, 0.05}, {2.0, 2.0, 0.05}).fraction;
  const double ahead = world.castRay({3.0, 2.0, 0.05}, {2.0, 2.0, 0.05}).fraction;
  EXPECT_NEAR(left, 1.0 - 0.11, 1e-9);
  EXPECT_NEAR(ahead, 1.0 - 0.085, 1e-9);
}

TEST(TurretTest, ThatOfAMirrorIsWhereTheSpaceSays) {
  World world;
  const Row mirror = world.add(robotModel("footbot"), flatPose(2.0, 2.0), Role::kMirror);
  world.space.joints[mirror][0].angle = M_PI / 2.0;
  world.step();
  const Row footbot = world.addFootbot(flatPose(2.0, 3.0, -M_PI / 2.0));
  world.drive(footbot, 0.1);
  world.step(100);
  // tip to tip
  EXPECT_NEAR(world.pose(footbot).position.y(), 2.22, 0.011);
  EXPECT_GE(world.pose(footbot).position.y(), 2.22 - 1e-9);
}

TEST(TurretTest, StopsBeforeWhatIsInTheWay) {
  World world({10.0, 10.0, 2.0}, 10);
  const Row footbot = world.addTurret(flatPose(2.0, 2.0));
  world.addBlock({0.5, 0.02, 0.2}, {2.0, 2.11, 0.1});  // its near side at y = 2.1, in the way of the tip
  world.turret(footbot).turnAt(1.0);
  world.step(30);
  // angle at which a corner of the gripper, 0.11 ahead and 0.02 to the left, reaches y = 0.1
  const double reached = std::asin(0.1 / std::hypot(0.11, 0.02)) - std::atan2(0.02, 0.11);
  EXPECT_LE(world.turretState(footbot).angle, reached + 1e-9);
  EXPECT_GE(world.turretState(footbot).angle, reached - 0.01 - 1e-9);
  EXPECT_EQ(world.turretState(footbot).speed, 0.0);
  world.turret(footbot).turnAt(-1.0);
  world.step();
  EXPECT_NEAR(world.turretState(footbot).speed, -1.0, 1e-9);
}

TEST(TurretTest, WhatIsHeldTurnsAroundTheRobot) {
  for (const int subclock : {1, 4}) {
    Holder holder(subclock);
    ASSERT_EQ(holder.world.space.structure.grippedBy(holder.footbot), holder.prey);
    holder.turret().turnAt(2.0);
    holder.world.step(100);
    EXPECT_NEAR(std::remainder(holder.angle() - 20.0, 2.0 * M_PI), 0.0, 1e-9);
    EXPECT_NEAR(std::remainder(holder.bearing() - 20.0, 2.0 * M_PI), 0.0, 1e-9);
    EXPECT_NEAR(holder.way().norm(), Holder::kArm, 1e-12);
    EXPECT_NEAR(std::remainder(headingOf(holder.world.pose(holder.prey)) - 20.0, 2.0 * M_PI), 0.0, 1e-9);
    EXPECT_NEAR(holder.world.twist(holder.prey).angular.z(), 2.0, 1e-9);
    EXPECT_EQ(holder.world.twist(holder.footbot).linear, Vector3d::Zero());
  }
}

TEST(TurretTest, WhatIsHeldStopsItAtAnObstacle) {
  Holder holder(10);
  World& world = holder.world;
  world.addBlock({1.0, 0.02, 0.2}, {2.0, 2.21, 0.1});  // its near side at y = 2.2
  holder.turret().turnAt(1.0);
  world.step(50);
  const double reached = std::asin(0.1 / Holder::kArm);  // angle at which the prey touches
  EXPECT_LE(holder.angle(), reached + 1e-9);
  EXPECT_GE(holder.angle(), reached - 0.01 - 1e-9);
  world.drive(holder.footbot, -0.1);
  world.step(30);
  EXPECT_LT(world.pose(holder.footbot).position.x(), 1.8);  // the robot itself goes on
}

TEST(TurretTest, UnderAPassiveOneTheChassisTurnsAlone) {
  Holder holder;
  holder.turret().letTurn();
  const Pose prey = holder.world.pose(holder.prey);
  holder.world.drive(holder.footbot, 0.0, 0.7);
  holder.world.step(100);
  EXPECT_LT((holder.world.pose(holder.prey).position - prey.position).norm(), 1e-12);
  EXPECT_LT(holder.world.pose(holder.prey).orientation.angularDistance(prey.orientation), 1e-7);
  EXPECT_NEAR(std::remainder(headingOf(holder.world.pose(holder.footbot)) - 7.0, 2.0 * M_PI), 0.0, 1e-9);
  EXPECT_NEAR(std::remainder(holder.angle() + 7.0, 2.0 * M_PI), 0.0, 1e-9);
  EXPECT_NEAR(holder.world.turretState(holder.footbot).speed, -0.7, 1e-9);
}

TEST(TurretTest, WhatAPassiveOneHoldsTrails) {
  Holder holder(10);
  World& world = holder.world;
  holder.turret().letTurn();
  world.drive(holder.footbot, 0.0, M_PI / 2.0);
  world.step(10);  // now it drives across
  EXPECT_NEAR(holder.angle(), -M_PI / 2.0, 1e-9);
  world.drive(holder.footbot, 0.1);
  for (const double way : {0.1, 0.2, 0.5}) {
    world.step(static_cast<int>(std::lround((2.0 + way - world.pose(holder.footbot).position.y()) / 0.01)));
    // a tractrix: the tangent of half the angle between rope and way back decreases exponentially
    const double expected = -M_PI + 2.0 * std::atan(std::exp(-way / Holder::kArm));
    EXPECT_NEAR(holder.angle(), expected, 0.005) << way;
    EXPECT_NEAR(holder.way().norm(), Holder::kArm, 1e-12);
  }
}

TEST(TurretTest, GripsWhereItIsTurnedTo) {
  World world;
  const Row footbot = world.addTurret(flatPose(2.0, 2.0));
  const Row ahead = world.addPrey(0.1, 0.12, 2.24, 2.0);
  const Row behind = world.addPrey(0.1, 0.12, 1.775, 2.0);
  world.turret(footbot).holdAngle(M_PI);
  world.step(12);
  world.setGripper(footbot, true);
  world.step();
  EXPECT_EQ(world.space.structure.grippedBy(footbot), behind);
  EXPECT_TRUE(world.space.structure.grippersOf(ahead).empty());
}

TEST(TurretTest, TurnsTheSameWayOnAWall) {
  const Eigen::Quaterniond feet_on_wall(Eigen::AngleAxisd(-M_PI / 2.0, Vector3d::UnitY()));  // x is up, y stays y
  World world({10.0, 10.0, 10.0}, 1, "x", 3.0);
  const Row footbot = world.addTurret({{3.0, 5.0, 5.0}, feet_on_wall});
  const Row prey = world.add(cylindricPreyModel(0.1, 0.12), {{3.0, 5.22, 5.0}, feet_on_wall});
  world.turret(footbot).holdAngle(M_PI / 2.0);
  world.step(6);
  world.setGripper(footbot, true);
  world.step();
  ASSERT_EQ(world.space.structure.grippedBy(footbot), prey);
  world.turret(footbot).holdAngle(0.0);
  world.step(6);
  EXPECT_LT((world.pose(prey).position - Vector3d(3.0, 5.0, 5.22)).norm(), 1e-9);
}

/// A crowd with walls and preys; every third robot grips. @return state of all bodies that moved
std::vector<double> crowd(bool has_turrets, bool turns) {
  World world({3.0, 3.0, 2.0}, 2);
  std::vector<Row> rows;
  for (int i = 0; i < 36; ++i) {
    const double heading = 0.7 * i;
    const Pose pose = flatPose(0.25 + 0.5 * (i % 6), 0.25 + 0.5 * (i / 6), heading);
    const Row row = has_turrets ? world.addTurret(pose) : world.addRobot(robotModel("footbot"), pose);
    rows.push_back(row);
    world.drive(row, 0.15, 0.2 * (i % 7 - 3));
    world.setGripper(row, i % 3 == 0);
    if (turns) {
      world.turret(row).turnAt(0.3 * (i % 5 - 2));
    }
    if (i % 9 == 0) {
      rows.push_back(world.addPrey(0.06, 0.12, pose.position.x() + 0.18 * std::cos(heading),
                                   pose.position.y() + 0.18 * std::sin(heading)));
    }
  }
  world.step(200);
  std::vector<double> state;
  int grips = 0;
  for (const Row row : rows) {
    grips += world.space.structure.grippedBy(row) != kNoRow ? 1 : 0;
    const Pose& pose = world.pose(row);
    const auto& q = pose.orientation;
    state.insert(state.end(), {pose.position.x(), pose.position.y(), q.z(), q.w(), world.turretState(row).angle,
                               world.twist(row).linear.x()});
  }
  EXPECT_GT(grips, 0);
  return state;
}

TEST(TurretTest, OneThatHoldsStraightIsAsIfThereWereNone) { EXPECT_EQ(crowd(true, false), crowd(false, false)); }

TEST(TurretTest, RepeatsToTheBit) {
  EXPECT_EQ(crowd(true, true), crowd(true, true));
  EXPECT_NE(crowd(true, true), crowd(true, false));
}

TEST(TurretTest, TurningAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  Holder holder(3);
  World& world = holder.world;
  const Row other = world.addTurret(flatPose(3.0, 2.0));
  world.addBlock({0.02, 0.5, 0.2}, {3.105, 2.0, 0.1});
  const auto tick = [&](int i) {
    holder.turret().turnAt(i % 40 < 20 ? 1.0 : -1.0);
    world.turret(other).turnAt(i % 100 < 50 ? 2.0 : -2.0);
    world.step();
  };
  for (int i = 0; i < 200; ++i) {
    tick(i);
  }
  const long before = heap_allocations;
  for (int i = 200; i < 400; ++i) {
    tick(i);
  }
  EXPECT_EQ(heap_allocations - before, 0);
  EXPECT_GT(before, 100);  // the counting works
}

}  // namespace
}  // namespace swarmanoid::kinematics2d
