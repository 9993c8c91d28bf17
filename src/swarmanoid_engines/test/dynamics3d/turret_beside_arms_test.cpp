// A robot with arms and a turret, all commanded: the turret is a link like those of the arms.
#include <gtest/gtest.h>

#include <limits>

#include "swarmanoid_experiment_files/robots/robot_model.hpp"
#include "world.hpp"

namespace swarmanoid::dynamics3d {
namespace {

constexpr std::size_t kElbow = 1;  // the left one
constexpr std::size_t kMast = 6;
constexpr double kInertia = 0.01;  // kg m2, of the mast about its axis

/// A handbot with a mast on its axis. @param effort of its motor [N m]
std::shared_ptr<const EntityModel> handbotWithMast(double effort) {
  auto model = std::make_shared<EntityModel>(*robotModel("handbot"));
  EntityModel::Joint mast;
  mast.name = "mast";
  mast.link = "mast_link";
  mast.frame.position = {0.0, 0.0, 0.3};
  mast.lower = -std::numeric_limits<double>::infinity();
  mast.upper = std::numeric_limits<double>::infinity();
  mast.max_speed = 1.5;
  mast.max_effort = effort;
  mast.part = {0.2, {0.0, 0.0, 0.35}, kInertia * Eigen::Matrix3d::Identity()};
  model->joints.push_back(mast);
  return model;
}

struct MastWorld : World {
  MastWorld(double effort, const JointCommand& command)
      : robot(addToSpace(handbotWithMast(effort), flatPose(2.0, 2.0))) {
    space.joint_commands[robot][kElbow] = {JointCommand::Mode::kAngle, 0.5};
    space.joint_commands[robot][kMast] = command;
    engine.add(space, robot, Role::kMove);
    space.mover[robot] = &engine;
  }

  const Row robot;
};

TEST(TurretBesideArmsTest, BothGoWhereTheyAreCommanded) {
  MastWorld world(2.0, {JointCommand::Mode::kAngle, 0.7});
  EXPECT_EQ(turretJoint(*world.space.entities.model[world.robot]), static_cast<int>(kMast));
  world.step(20);
  EXPECT_NEAR(world.space.joints[world.robot][kMast].angle, 0.7, 1e-3);
  EXPECT_NEAR(world.space.joints[world.robot][kElbow].angle, 0.5, 1e-3);
}

/// A turret without load turns at the commanded speed; a link has an inertia: 0.001 N m give it 0.1 rad/s2.
TEST(TurretBesideArmsTest, ItsMotorAcceleratesItsLink) {
  MastWorld world(0.001, {JointCommand::Mode::kSpeed, 1.5});
  world.step(10);
  EXPECT_NEAR(world.space.joints[world.robot][kMast].speed, 0.1, 0.02);
  EXPECT_NEAR(world.space.joints[world.robot][kMast].angle, 0.05, 0.01);
}

}  // namespace
}  // namespace swarmanoid::dynamics3d
