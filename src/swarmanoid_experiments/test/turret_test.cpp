// A footbot that turns its turret, from the experiment file to the reading, through all engines.
#include <gtest/gtest.h>

#include <cmath>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "test_world.hpp"

namespace swarmanoid::test {
namespace {

/// Turns to a right angle, grips, turns back, and reports its readings.
class TestTurning final : public Controller {
 public:
  void init(Robot& robot, const Configuration& parameters) override {
    robot_ = &robot;
    turret_ = &robot.actuator<FootbotTurret>();
    gripper_ = &robot.actuator<FootbotGripper>();
    state_ = &robot.sensor<FootbotTurretState>();
    parameters.refuseUnread();
  }
  void step(Time, Duration) override {
    const int tick = tick_++;
    turret_->holdAngle(tick < 10 ? M_PI / 2.0 : 0.0);
    gripper_->closed = tick >= 8;
    robot_->debug("turret", std::to_string(state_->angle));
  }

 private:
  Robot* robot_ = nullptr;
  FootbotTurret* turret_ = nullptr;
  FootbotGripper* gripper_ = nullptr;
  const FootbotTurretState* state_ = nullptr;
  int tick_ = 0;
};

std::unique_ptr<Simulation> world() {
  loadBuiltInPlugins();
  const std::string text =
      "<ahss-config><framework><clocktick>100</clocktick><maxclock>1000</maxclock></framework><controllers>"
      "<test_turning id='turning' "
      "library='swarmanoid_devices'><actuators><footbot_turret/><footbot_gripper/></actuators>"
      "<sensors><footbot_turret_state/></sensors></test_turning></controllers><arena size='5,5,2' optimization='2D'>"
      "<footbot id='fb'><position>2,2,0</position><orientation>0,0,0</orientation><controller>turning</controller>"
      "</footbot><cylindric_prey id='prey'><position>2,2.18,0</position><orientation>0,0,0</orientation>"
      "<radius>0.06</radius><height>0.1</height></cylindric_prey></arena><engines><kinematics2d id='plain'/>"
      "<dynamics2d id='forces'><subclock>10</subclock></dynamics2d><dynamics3d id='space'/></engines><arena_physics>"
      "<engine id='plain'><entity id='fb'/><entity id='prey'/></engine></arena_physics></ahss-config>";
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "test.xml"));
  simulation->start();
  return simulation;
}

/// Angle of the turret, as read by the controller [rad].
double readingOf(const Simulation& simulation) {
  const Space& space = simulation.space();
  for (const auto& [key, value] : space.robots[space.entities.find("fb")]->debugValues()) {
    if (key == "turret") {
      return std::stod(value);
    }
  }
  ADD_FAILURE() << "says nothing";
  return 0.0;
}

/// @param engines to which the robot is handed over, one after the other, from tick 11 on, each for two ticks
std::vector<std::uint64_t> run(Simulation& simulation, const std::vector<std::string>& engines) {
  std::vector<std::uint64_t> hashes = hashesOf(simulation, 11);
  const Space& space = simulation.space();
  const Row footbot = space.entities.find("fb");
  EXPECT_NEAR(readingOf(simulation), M_PI / 2.0, 1e-6);
  EXPECT_EQ(space.structure.grippedBy(footbot), space.entities.find("prey"));
  for (const std::string& engine : engines) {
    const JointState before = space.joints[footbot][0];
    simulation.apply(HandOverEntity{"fb", engine});
    EXPECT_EQ(space.joints[footbot][0].angle, before.angle);
    EXPECT_EQ(space.joints[footbot][0].speed, before.speed);
    const auto next = hashesOf(simulation, 2);
    hashes.insert(hashes.end(), next.begin(), next.end());
  }
  const auto last = hashesOf(simulation, 20);
  hashes.insert(hashes.end(), last.begin(), last.end());
  EXPECT_NEAR(readingOf(simulation), 0.0, 0.02);
  EXPECT_EQ(space.structure.grippedBy(footbot), space.entities.find("prey"));
  const Eigen::Vector3d way = poseOf(simulation, "prey").position - poseOf(simulation, "fb").position;
  EXPECT_NEAR(std::atan2(way.y(), way.x()), headingOf(simulation, "fb"), 0.03);
  EXPECT_NEAR(way.norm(), 0.18, 2e-3);
  return hashes;
}

TEST(TurretTest, TurnsWhatItGripsInEachEngineAndOnItsWayThroughAll) {
  for (const std::vector<std::string>& engines :
       {std::vector<std::string>{}, {"forces"}, {"space"}, {"forces", "space", "plain", "space", "forces"}}) {
    const auto simulation = world();
    const auto hashes = run(*simulation, engines);
    simulation->reset();
    EXPECT_EQ(run(*simulation, engines), hashes) << "after a reset";
    EXPECT_EQ(run(*world(), engines), hashes) << "in a fresh world";
  }
}

TEST(TurretTest, WhatOverlapsATurnedGripperKeepsItFromBeingMovedThere) {
  const auto simulation = world();
  hashesOf(*simulation, 8);
  // the gripper now points to the left: there is no free place beside a prey on the left, but there is one on the right
  const Pose& prey = poseOf(*simulation, "prey");
  const auto at = [&](double y) { return Pose{prey.position + Eigen::Vector3d(0.0, y, 0.0), prey.orientation}; };
  EXPECT_THROW(simulation->apply(MoveEntity{"fb", at(-0.16)}), ConfigError);
  EXPECT_NO_THROW(simulation->apply(MoveEntity{"fb", at(0.16)}));
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::TestTurning, "test_turning")
