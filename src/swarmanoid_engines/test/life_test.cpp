// Entities that the engine accepts; removed entities leave no trace.
#include <gtest/gtest.h>

#include <vector>

#include "world.hpp"

namespace swarmanoid::kinematics2d {
namespace {

using testing::Test;

TEST(LifeTest, IsRegisteredUnderBothNames) {
  const auto* found = Registry::instance().find(PluginKind::kEngine, "dummy_engine");
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->description.label, "kinematics2d");
  ASSERT_EQ(found->description.parameters.size(), 3U);
}

TEST(LifeTest, RefusesADeviceThatTheRobotHasNoPartsFor) {
  World world;
  EntityModel bare = *discModel(0.1, 0.1);
  bare.wheels.reset();
  EXPECT_EQ(world.engine.unsupportedReason(*footbotModel(),
                                           test::uses({"footbot_wheels", "footbot_gripper", "footbot_proximity"})),
            "");
  EXPECT_EQ(world.engine.unsupportedReason(bare, test::uses({"footbot_proximity", "eyebot_velocity"})), "");
  EXPECT_EQ(world.engine.unsupportedReason(bare, test::uses({"footbot_wheels"})),
            "device 'footbot_wheels' cannot be simulated: a robot of this type has no wheels");
  EXPECT_EQ(world.engine.unsupportedReason(bare, test::uses({"footbot_gripper"})),
            "device 'footbot_gripper' cannot be simulated: a robot of this type has no gripper");
  EXPECT_EQ(world.engine.unsupportedReason(*footbotModel(), test::uses({"footbot_wheels", "eyebot_velocity"})),
            "device 'eyebot_velocity' cannot be simulated: another device drives the robot already");
  EXPECT_NE(world.engine.unsupportedReason(*lightModel(), {}), "");
}

TEST(LifeTest, SaysWhereAMisplacedRobotIsAndBelongs) {
  World world({10.0, 10.0, 4.0}, 1, "z", 2.0);
  EXPECT_EQ(world.engine.invalidPoseReason(*footbotModel(), flatPose(1.0, 1.0, 0.0, 2.0 + 0.9e-6)), "");
  EXPECT_EQ(world.engine.invalidPoseReason(*footbotModel(), flatPose(1.0, 1.0, 0.0, 0.5)),
            "found at z = 0.5, allowed: in the engine's plane, z = 2");
  EXPECT_NE(world.engine.invalidPoseReason(*footbotModel(), flatPose(1.0, 1.0, 0.0, 2.0 + 2e-6)), "");
  EXPECT_EQ(world.engine.invalidPoseReason(*blockModel({1.0, 1.0, 1.0}), flatPose(1.0, 1.0, 0.0, 0.5)), "");
}

TEST(LifeTest, RefusesARobotThatDoesNotStandOnItsTreels) {
  World world;
  const auto tilted = [](double angle, const Eigen::Vector3d& axis) {
    return Pose{{1.0, 1.0, 0.0}, Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis.normalized()))};
  };
  const Pose pose = tilted(0.17, {1.0, 0.4, 0.0});
  EXPECT_EQ(world.engine.invalidPoseReason(*footbotModel(), pose),
            "found tilted, allowed: standing on its treels, its z axis along z");
  EXPECT_NE(world.engine.invalidPoseReason(*footbotModel(), tilted(M_PI / 2.0, {0.0, 1.0, 0.0})), "");
  EXPECT_EQ(world.engine.invalidPoseReason(*footbotModel(), tilted(0.83, {0.0, 0.0, 1.0})), "");
  EXPECT_EQ(world.engine.invalidPoseReason(*cylindricPreyModel(0.1, 0.1), pose), "")
      << "what has no treels may lie as it does";
}

TEST(LifeTest, RefusesAnAxisThatIsNone) {
  Kinematics2d engine;
  Configuration configuration;
  configuration.set("perpendicular_axis", "w");
  EXPECT_THROW(engine.configure("e", configuration), ConfigError);
}

TEST(LifeTest, ComingAndGoingAThousandTimesLeavesNoTrace) {
  World used;
  const Row wall = used.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25});
  for (int i = 0; i < 1000; ++i) {
    const Row robot = used.addFootbot(flatPose(1.5, 2.0, 0.01 * i));
    const Row prey = used.add(cylindricPreyModel(0.1, 0.1), flatPose(1.5, 2.5));
    Pose tilted = flatPose(5.0, 5.0, 0.0, 0.5);
    tilted.orientation = Eigen::AngleAxisd(0.001 * i, Eigen::Vector3d::UnitX());
    const Row block = used.add(blockModel({2.0, 0.1, 0.1}), tilted);
    used.drive(robot, 0.1);
    used.step();
    for (const Row row : {robot, prey, block}) {
      used.remove(row);
    }
    EXPECT_LT(toIndex(robot), 4U);
  }
  EXPECT_EQ(used.engine.overlap(*discModel(0.3, 0.1), flatPose(1.5, 2.2), kNoRow), kNoRow);
  EXPECT_EQ(used.castRay({1.0, 2.0, 0.05}, {1.9, 2.0, 0.05}).row, kNoRow);
  EXPECT_EQ(used.castRay({1.0, 2.0, 0.05}, {2.9, 2.0, 0.05}).row, wall);

  World fresh;
  fresh.addBlock({0.1, 4.0, 0.5}, {2.0, 2.0, 0.25});
  const Row here = used.addFootbot(flatPose(1.0, 2.0, 0.4));
  const Row there = fresh.addFootbot(flatPose(1.0, 2.0, 0.4));
  used.drive(here, 0.2, 0.1);
  fresh.drive(there, 0.2, 0.1);
  used.step(100);
  fresh.step(100);
  EXPECT_EQ(used.pose(here).position, fresh.pose(there).position);
  EXPECT_EQ(used.pose(here).orientation.coeffs(), fresh.pose(there).orientation.coeffs());
}

TEST(LifeTest, PlacedRobotsGoOnFromTheirNewPlace) {
  World world;
  const Row row = world.addFootbot(flatPose(1.0, 1.0));
  world.drive(row, 0.1);
  world.step(10);
  world.pose(row) = flatPose(9.0, 9.0, M_PI);
  world.engine.place(world.space, row);
  world.step(10);
  EXPECT_NEAR(world.pose(row).position.x(), 8.9, 1e-12);
  EXPECT_EQ(world.engine.overlap(*discModel(0.3, 0.1), flatPose(1.1, 1.0), kNoRow), kNoRow);
}

TEST(LifeTest, ClearForgetsEverything) {
  World world;
  world.addFootbot(flatPose(1.0, 1.0));
  world.addBlock({4.0, 0.1, 1.0}, {3.0, 3.0, 0.5});
  world.engine.clear();
  EXPECT_EQ(world.engine.overlap(*discModel(5.0, 0.1), flatPose(2.0, 2.0), kNoRow), kNoRow);
  EXPECT_EQ(world.castRay({0.0, 3.0, 0.5}, {5.0, 3.0, 0.5}).row, kNoRow);
  world.step();
}

TEST(LifeTest, OutsideTheArenaRobotsStillMoveAndMeet) {
  World world({2.0, 2.0, 1.0});
  const Row row = world.addRobot(discModel(0.1, 0.15), flatPose(-3.0, -3.0));
  const Row other = world.addRobot(discModel(0.1, 0.15), flatPose(-2.5, -3.0));
  world.drive(row, 0.1);
  world.step(100);
  EXPECT_NEAR(world.pose(row).position.x(), -2.7, 1e-9);
  EXPECT_EQ(world.castRay({-3.5, -3.0, 0.1}, {0.0, -3.0, 0.1}, row).row, other);
}

}  // namespace
}  // namespace swarmanoid::kinematics2d
