// Turrets in three dimensions: hinges with motors between robots and their loads.
#include <gtest/gtest.h>

#include <vector>

#include "../turret_models.hpp"
#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

using Eigen::Vector3d;

constexpr double kArm = 0.22;  // m from a footbot's centre to that of a gripped prey

/// A footbot with a turret at (2, 2), closed on a prey ahead.
struct Holder {
  explicit Holder(double prey_mass, const std::shared_ptr<const EntityModel>& model = robotModel("footbot"),
                  World::Values values = {}, double height = 0.0)
      : world(values) {
    footbot = world.addTurret(flatPose(2.0, 2.0, 0.0, height), model);
    prey = world.add(cylindricPreyModel(0.1, 0.12, prey_mass), flatPose(2.0 + kArm, 2.0, 0.0, height));
    world.setGripper(footbot, true);
    world.step();
  }
  FootbotTurret& turret() { return world.turret(footbot); }
  const JointState& state() const { return world.turretState(footbot); }
  double heading() const { return headingOf(world.pose(footbot)); }
  bool isHolding() const { return world.gripped(footbot) == prey; }

  World world;
  Row footbot = kNoRow;
  Row prey = kNoRow;
};

TEST(TurretTest, WithoutLoadItTurnsAsTold) {
  World world;
  const Row footbot = world.addTurret(flatPose(2.0, 2.0));
  world.turret(footbot).holdAngle(2.0);
  world.step(6);
  EXPECT_NEAR(world.turretState(footbot).angle, 6 * 0.1 * kTurretSpeed, 1e-9);
  EXPECT_NEAR(world.turretState(footbot).speed, kTurretSpeed, 1e-9);
  world.step();
  EXPECT_EQ(world.turretState(footbot).angle, 2.0);
  world.step();
  EXPECT_EQ(world.turretState(footbot).speed, 0.0);
  EXPECT_LT((world.pose(footbot).position - Vector3d(2.0, 2.0, 0.0)).norm(), 1e-3);
}

TEST(TurretTest, TheGripperCatchesWhereItIsTurned) {
  for (const double angle : {0.0, M_PI / 2.0}) {
    World world;
    const Row footbot = world.addTurret(flatPose(2.0, 2.0));
    world.addBlock({0.1, 0.1, 0.2}, 0.0, flatPose(2.3, 2.15, 0.0, 0.1));  // blocks only a gripper that is turned left
    world.turret(footbot).holdAngle(angle);
    world.step(6);
    world.drive(footbot, 0.1);
    world.step(60);
    if (angle == 0.0) {
      EXPECT_NEAR(world.pose(footbot).position.x(), 2.6, 0.02);
    } else {
      EXPECT_LT(world.pose(footbot).position.x(), 2.5) << "it slides around what holds it";
      EXPECT_GT(headingOf(world.pose(footbot)), 0.2) << "what catches it on its left turns it to the left";
    }
  }
}

TEST(TurretTest, ThatOfAMirrorIsWhereTheSpaceSays) {
  World world;
  const Row mirror = world.add(robotModel("footbot"), flatPose(2.0, 2.0), Role::kMirror);
  world.space.joints[mirror][0].angle = M_PI / 2.0;
  world.step();
  const Row footbot = world.addFootbot(flatPose(2.0, 3.0, -M_PI / 2.0));
  world.drive(footbot, 0.1);
  world.step(100);
  EXPECT_NEAR(world.pose(footbot).position.y(), 2.22, 0.01) << "tip to tip";
}

TEST(TurretTest, WithoutLoadItStopsBeforeWhatIsInTheWay) {
  World world;
  const Row footbot = world.addTurret(flatPose(2.0, 2.0));
  world.addBlock({0.5, 0.02, 0.2}, 0.0, flatPose(2.0, 2.11, 0.0, 0.1));  // its near side at y = 2.1
  world.turret(footbot).turnAt(1.0);
  world.step(30);
  const double reached = std::asin(0.1 / std::hypot(0.11, 0.02)) - std::atan2(0.02, 0.11);
  EXPECT_NEAR(world.turretState(footbot).angle, reached, 0.02);
  EXPECT_LT(world.turretState(footbot).angle, reached);
  EXPECT_LT((world.pose(footbot).position - Vector3d(2.0, 2.0, 0.0)).norm(), 1e-3) << "nothing pushes it away";
  world.turret(footbot).turnAt(-1.0);
  world.step();
  EXPECT_NEAR(world.turretState(footbot).speed, -1.0, 1e-9);
}

TEST(TurretTest, WithoutLoadItStopsBeforeWhatWasPutThere) {
  // the gripper would touch it in the first step
  const auto turned = [](bool is_put_there) {
    World world;
    const Row footbot = world.addTurret(flatPose(2.0, 2.0, 0.92));
    const Pose near = flatPose(2.0, 2.11, 0.0, 0.1);
    const Row block = world.addBlock({0.5, 0.02, 0.2}, 0.0, is_put_there ? flatPose(7.0, 7.0, 0.0, 0.1) : near);
    world.step();
    if (is_put_there) {
      world.place(block, near);
    }
    world.turret(footbot).turnAt(kTurretSpeed);
    world.step();
    return world.turretState(footbot).angle;
  };
  EXPECT_EQ(turned(false), 0.0);
  EXPECT_EQ(turned(true), 0.0);
}

TEST(TurretTest, ALightLoadTurnsAroundTheRobot) {
  Holder holder(0.3);
  ASSERT_TRUE(holder.isHolding());
  holder.turret().turnAt(0.5);  // the treels hold against the torque that accelerates it
  holder.world.step(20);
  EXPECT_NEAR(holder.state().angle, 1.0, 0.01);
  EXPECT_NEAR(holder.heading(), 0.0, 0.02);
  const Vector3d way = holder.world.pose(holder.prey).position - holder.world.pose(holder.footbot).position;
  EXPECT_NEAR(std::atan2(way.y(), way.x()), 1.0, 0.03);
  EXPECT_NEAR(way.norm(), kArm, 1e-3);
}

TEST(TurretTest, AHeavyLoadTurnsTheRobotTheOtherWay) {
  Holder holder(100.0);
  const Pose prey = holder.world.pose(holder.prey);
  holder.turret().holdAngle(0.8);
  holder.world.step(40);
  EXPECT_NEAR(holder.state().angle, 0.8, 0.008);
  EXPECT_NEAR(holder.heading(), -0.8, 0.008);
  EXPECT_LT((holder.world.pose(holder.prey).position - prey.position).norm(), 2e-3);
  EXPECT_LT((holder.world.pose(holder.footbot).position - Vector3d(2.0, 2.0, 0.0)).norm(), 2e-3);
  EXPECT_TRUE(holder.isHolding());
}

TEST(TurretTest, SlipsBeyondItsTorqueAndHoldsBelow) {
  // torque of slipping treels on the robot, measured by a turret that no treel can turn
  Holder strong(100.0, footbotOfTorque(100.0));
  strong.world.drive(strong.footbot, 0.0, 1.0);
  strong.world.step(20);
  const double treels = strong.state().effort;
  EXPECT_GT(treels, 1.0);
  EXPECT_LT(treels, robotModel("footbot")->joints[0].max_effort);
  for (const double share : {0.95, 1.05}) {
    Holder holder(100.0, footbotOfTorque(share * treels));
    holder.world.drive(holder.footbot, 0.0, 1.0);
    holder.world.step(20);
    EXPECT_TRUE(holder.isHolding());
    if (share < 1.0) {
      EXPECT_GT(holder.heading(), 1.5) << "the treels turn the robot under its turret";
      EXPECT_NEAR(holder.state().angle, -holder.heading(), 0.01);
      EXPECT_NEAR(holder.state().effort, share * treels, 0.01 * treels);
    } else {
      EXPECT_NEAR(holder.heading(), 0.0, 0.02) << "the treels slip";
    }
  }
}

TEST(TurretTest, ItsTorqueTurnsLoadsAsNewtonSays) {
  // without gravity and ground, the motor turns robot and load against each other
  constexpr double kTorque = 0.004;  // N m
  constexpr double kMass = 2.0;
  Holder holder(kMass, footbotOfTorque(kTorque), {{"gravity", "0"}, {"ground", "false"}}, 0.5);
  ASSERT_TRUE(holder.isHolding());
  holder.turret().turnAt(kTurretSpeed);
  holder.world.step(10);
  const EntityModel& robot = *robotModel("footbot");
  const double reduced = robot.mass * kMass / (robot.mass + kMass);
  const double load = 0.5 * kMass * 0.01 + reduced * kArm * kArm;  // about the robot's centre, which gives way
  EXPECT_NEAR(holder.state().speed, kTorque * (1.0 / robot.inertia(2, 2) + 1.0 / load), 0.01 * holder.state().speed);
  EXPECT_NEAR(holder.state().effort, kTorque, 0.01 * kTorque);
}

TEST(TurretTest, UnderAPassiveOneTheChassisTurnsAlone) {
  for (const bool is_passive : {true, false}) {
    Holder holder(100.0);
    const Pose prey = holder.world.pose(holder.prey);
    if (is_passive) {
      holder.turret().letTurn();
    }
    holder.world.drive(holder.footbot, 0.0, 1.0);
    holder.world.step(20);
    EXPECT_NEAR(holder.heading(), is_passive ? 2.0 : 0.0, 0.05);
    EXPECT_NEAR(holder.state().angle, is_passive ? -2.0 : 0.0, 0.05);
    EXPECT_EQ(std::abs(holder.state().effort) < 1e-3, is_passive);
    EXPECT_LT((holder.world.pose(holder.prey).position - prey.position).norm(), 2e-3);
  }
}

TEST(TurretTest, WhatAPassiveOneHoldsTrails) {
  Holder holder(1.0);
  holder.turret().letTurn();
  holder.world.drive(holder.footbot, 0.0, M_PI / 2.0);
  holder.world.step(10);
  EXPECT_NEAR(holder.state().angle, -M_PI / 2.0, 0.1);
  holder.world.drive(holder.footbot, 0.1);
  holder.world.step(80);
  EXPECT_LT(std::abs(holder.state().angle), M_PI);
  EXPECT_GT(std::abs(holder.state().angle), 2.8) << "behind";
  EXPECT_NEAR((holder.world.pose(holder.prey).position - holder.world.pose(holder.footbot).position).norm(), kArm,
              2e-3);
}

TEST(TurretTest, GripsWhereItIsTurnedTo) {
  World world;
  const Row footbot = world.addTurret(flatPose(2.0, 2.0));
  const Row ahead = world.addPrey(0.1, 0.12, 0.3, 2.24, 2.0);
  const Row behind = world.addPrey(0.1, 0.12, 0.3, 1.775, 2.0);
  world.turret(footbot).holdAngle(M_PI);
  world.step(12);
  world.setGripper(footbot, true);
  world.step();
  EXPECT_EQ(world.gripped(footbot), behind);
  EXPECT_TRUE(world.space.structure.grippersOf(ahead).empty());
}

std::vector<double> dance() {
  World world;
  std::vector<Row> rows;
  for (int i = 0; i < 9; ++i) {
    rows.push_back(world.addTurret(flatPose(0.5 + 0.4 * (i % 3), 0.5 + 0.4 * (i / 3), 0.7 * i)));
    world.drive(rows.back(), 0.1, 0.2 * (i % 7 - 3));
    world.setGripper(rows.back(), i % 2 == 0);
    i % 5 == 4 ? world.turret(rows.back()).letTurn() : world.turret(rows.back()).turnAt(0.5 * (i % 5 - 2));
  }
  rows.push_back(world.addPrey(0.1, 0.12, 0.3, 0.5 + kArm, 0.5));
  world.step(30);
  std::vector<double> state;
  for (const Row row : rows) {
    const Pose& pose = world.pose(row);
    state.insert(state.end(), {pose.position.x(), pose.position.y(), pose.position.z(), pose.orientation.z(),
                               world.turretState(row).angle, world.turretState(row).speed});
  }
  EXPECT_EQ(world.gripped(rows[0]), rows.back());
  return state;
}

TEST(TurretTest, RepeatsToTheBit) { EXPECT_EQ(dance(), dance()); }

TEST(TurretTest, TurningAllocatesNothing) {
  if (SWARMANOID_COUNTS_ALLOCATIONS == 0) {
    GTEST_SKIP() << "the sanitizer has its own malloc";
  }
  Holder holder(0.3);
  World& world = holder.world;
  const Row other = world.addTurret(flatPose(3.0, 2.0));
  world.addBlock({0.02, 0.5, 0.2}, 0.0, flatPose(3.105, 2.0, 0.0, 0.1));
  const auto tick = [&](int i) {
    holder.turret().turnAt(i % 40 < 20 ? 1.0 : -1.0);
    world.turret(other).turnAt(i % 100 < 50 ? 2.0 : -2.0);
    world.step();
  };
  for (int i = 0; i < 100; ++i) {
    tick(i);
  }
  const long before = heap_allocations;
  for (int i = 100; i < 200; ++i) {
    tick(i);
  }
  EXPECT_EQ(heap_allocations - before, 0);
  EXPECT_GT(before, 100);  // the counting works
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
