// `joints` and `holders` have the same effects, to the last bit, as the robots' own devices, from the experiment file
// through the engines to the readings.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/devices/holders.hpp"
#include "swarmanoid_interface/devices/joints.hpp"
#include "swarmanoid_interface/plugin_library.hpp"
#include "swarmanoid_space/simulation/simulation.hpp"

namespace swarmanoid::test {
namespace {

/// Executed by each robot in each tick.
using Program = std::function<void(Robot& robot, int tick)>;
Program& program() {
  static Program program;
  return program;
}

class TestParts final : public Controller {
 public:
  void init(Robot& robot, const Configuration&) override { robot_ = &robot; }
  void step(Time, Duration) override { program()(*robot_, tick_++); }

 private:
  Robot* robot_ = nullptr;
  int tick_ = 0;
};

/// Readings of a joint and of a holder.
struct Reading {
  double angle = 0.0;
  double speed = 0.0;
  double effort = 0.0;
  bool is_holding = false;
  double length = 0.0;
  double force = 0.0;
};

bool operator==(const Reading& a, const Reading& b) {
  return a.angle == b.angle && a.speed == b.speed && a.effort == b.effort && a.is_holding == b.is_holding &&
         a.length == b.length && a.force == b.force;
}

struct Record {
  std::vector<std::uint64_t> hashes;  ///< of the state, after each tick
  std::vector<Reading> readings;      ///< in each tick, before the commands
};

/// @param engine its XML element
std::unique_ptr<Simulation> start(const std::string& engine, const std::string& robot, const std::string& devices,
                                  const std::string& others, const std::string& members) {
  loadBuiltInPlugins();
  const std::string text =
      "<ahss-config><framework><clocktick>100</clocktick><maxclock>1000</maxclock></framework><controllers>"
      "<test_parts id='c' library='swarmanoid_devices'>" +
      devices + "</test_parts></controllers><arena size='5,5,3' optimization='3D'><" + robot +
      " id='robot'><position>2,2,0</position><orientation>0,0,0</orientation><controller>c</controller></" + robot +
      ">" + others + "</arena><engines>" + engine + "</engines><arena_physics><engine id='e'><entity id='robot'/>" +
      members + "</engine></arena_physics></ahss-config>";
  auto simulation = std::make_unique<Simulation>(parseExperiment(text, "test.xml"));
  simulation->start();
  return simulation;
}

std::string devices(const std::string& actuators, const std::string& sensors) {
  return "<actuators>" + actuators + "</actuators><sensors>" + sensors + "</sensors>";
}

Record run(Simulation& simulation, int ticks, const std::function<void(Robot&, int)>& command,
           const std::function<Reading(const Robot&)>& read) {
  Record result;
  program() = [&](Robot& robot, int tick) {
    result.readings.push_back(read(robot));
    command(robot, tick);
  };
  for (int i = 0; i < ticks; ++i) {
    simulation.tick();
    result.hashes.push_back(simulation.stateHash());
  }
  return result;
}

void expectSame(const Record& expected, const Record& found) {
  EXPECT_EQ(expected.hashes, found.hashes);
  ASSERT_EQ(expected.readings.size(), found.readings.size());
  for (std::size_t k = 0; k < expected.readings.size(); ++k) {
    EXPECT_TRUE(expected.readings[k] == found.readings[k]) << "tick " << k;
  }
}

/// Turns to a prey at 0.7 rad, grips it, turns back with it, and releases the motor.
template <class Motor>
void turn(Motor& motor, int tick) {
  if (tick < 12) {
    motor.holdAngle(0.7);
  } else if (tick < 22) {
    motor.turnAt(-0.5);
  } else {
    motor.letTurn();
  }
}

constexpr int kClosesAt = 8;

// a prey 0.18 m from the footbot, at 0.7 rad
const std::string kPrey =
    "<cylindric_prey id='prey'><position>2.1376716,2.1159592,0</position><orientation>0,0,0</orientation>"
    "<radius>0.06</radius><height>0.1</height></cylindric_prey>";

Record turretRun(const std::string& engine) {
  const auto simulation =
      start(engine, "footbot",
            devices("<footbot_turret/><footbot_gripper/>", "<footbot_turret_state/><footbot_gripper_state/>"), kPrey,
            "<entity id='prey'/>");
  Record result = run(
      *simulation, 30,
      [](Robot& robot, int tick) {
        turn(robot.actuator<FootbotTurret>(), tick);
        robot.actuator<FootbotGripper>().closed = tick >= kClosesAt;
      },
      [](const Robot& robot) {
        const auto& turret = robot.sensor<FootbotTurretState>();
        return Reading{turret.angle, turret.speed, turret.torque, robot.sensor<FootbotGripperState>().gripping, 0, 0};
      });
  const Space& space = simulation->space();
  EXPECT_EQ(space.structure.grippedBy(space.entities.find("robot")), space.entities.find("prey")) << engine;
  return result;
}

Record jointsRun(const std::string& engine) {
  const auto simulation = start(engine, "footbot", devices("<joints/><holders/>", "<joint_states/><holder_states/>"),
                                kPrey, "<entity id='prey'/>");
  return run(
      *simulation, 30,
      [](Robot& robot, int tick) {
        turn(robot.actuator<Joints>().joints[0], tick);
        robot.actuator<Holders>().holders[0].holds = tick >= kClosesAt;
      },
      [](const Robot& robot) {
        const JointStates::Joint& turret = robot.sensor<JointStates>().joints[0];
        const HolderStates::Holder& gripper = robot.sensor<HolderStates>().holders[0];
        return Reading{turret.angle, turret.speed, turret.effort, gripper.is_holding, gripper.length, gripper.force};
      });
}

TEST(PartsOfAnyRobotTest, AFootbotsTurretAndGripperInEachEngine) {
  for (const std::string engine :
       {"<kinematics2d id='e'/>", "<dynamics2d id='e'><subclock>10</subclock></dynamics2d>", "<dynamics3d id='e'/>"}) {
    SCOPED_TRACE(engine);
    const Record expected = turretRun(engine);
    // without load it turns at 3 rad/s; readings are those of the tick before
    EXPECT_EQ(expected.readings[0].angle, 0.0);
    EXPECT_NEAR(expected.readings[1].angle, 0.3, 1e-9);
    EXPECT_NEAR(expected.readings[2].angle, 0.6, 1e-9);
    EXPECT_NEAR(expected.readings[3].angle, 0.7, 1e-9);
    EXPECT_FALSE(expected.readings[kClosesAt].is_holding);
    EXPECT_TRUE(expected.readings[kClosesAt + 2].is_holding);
    expectSame(expected, jointsRun(engine));
  }
}

constexpr std::size_t kElbow = 1;  // left elbow, index of the joint
constexpr std::size_t kRope = 2;   // index of the holder
const double kAngles[] = {-0.9, 0.55, 1.1, 0.35, -0.65, -2.1};
constexpr double kWinding = 0.13;  // m/s
constexpr int kWindsAt = 20;

const std::string kCeiling =
    "<block id='ceiling'><position>2,2,2.55</position><orientation>0,0,0</orientation><size>4,4,0.1</size>"
    "<ferromagnetic>true</ferromagnetic></block>";

Record armsRun() {
  const auto simulation = start("<dynamics3d id='e'/>", "handbot",
                                devices("<handbot_arms/><handbot_hands/><handbot_rope/>",
                                        "<handbot_arms_state/><handbot_hands_state/><handbot_rope_state/>"),
                                kCeiling, "<entity id='ceiling'/>");
  return run(
      *simulation, 50,
      [](Robot& robot, int tick) {
        robot.actuator<HandbotArms>().left = {kAngles[0], kAngles[1], kAngles[2]};
        robot.actuator<HandbotArms>().right = {kAngles[3], kAngles[4], kAngles[5]};
        robot.actuator<HandbotHands>().right = true;
        robot.actuator<HandbotRope>() = {true, tick < kWindsAt ? 0.0 : kWinding};
      },
      [](const Robot& robot) {
        const HandbotArmsState::Joint& elbow = robot.sensor<HandbotArmsState>().joints[kElbow];
        const auto& rope = robot.sensor<HandbotRopeState>();
        return Reading{elbow.angle, elbow.speed, elbow.effort, rope.attached, rope.length, rope.tension};
      });
}

Record armsByJointsRun() {
  const auto simulation =
      start("<dynamics3d id='e'/>", "handbot", devices("<joints/><holders/>", "<joint_states/><holder_states/>"),
            kCeiling, "<entity id='ceiling'/>");
  return run(
      *simulation, 50,
      [](Robot& robot, int tick) {
        for (std::size_t i = 0; i < std::size(kAngles); ++i) {
          robot.actuator<Joints>().joints[i].holdAngle(kAngles[i]);
        }
        robot.actuator<Holders>().holders[1].holds = true;
        robot.actuator<Holders>().holders[kRope] = {true, tick < kWindsAt ? 0.0 : kWinding};
      },
      [](const Robot& robot) {
        const JointStates::Joint& elbow = robot.sensor<JointStates>().joints[kElbow];
        const HolderStates::Holder& rope = robot.sensor<HolderStates>().holders[kRope];
        return Reading{elbow.angle, elbow.speed, elbow.effort, rope.is_holding, rope.length, rope.force};
      });
}

TEST(PartsOfAnyRobotTest, AHandbotsSixJointsAndItsRope) {
  const Record expected = armsRun();
  EXPECT_NEAR(expected.readings[kWindsAt].angle, 0.55, 0.01);
  ASSERT_TRUE(expected.readings[kWindsAt].is_holding);
  // from the 10th to the 25th tick of winding
  EXPECT_NEAR(expected.readings[kWindsAt + 10].length - expected.readings[kWindsAt + 25].length, 15 * 0.1 * kWinding,
              0.01);
  expectSame(expected, armsByJointsRun());
}

std::string refusalOf(const std::string& robot, const std::string& actuators, const std::string& sensors = "") {
  try {
    start("<kinematics2d id='e'/>", robot, devices(actuators, sensors), "", "");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(PartsOfAnyRobotTest, WhatTheRobotDoesNotHaveOrAnotherDeviceCommandsIsRefused) {
  const auto expectRefusal = [](const std::string& refusal, const std::string& expected) {
    EXPECT_NE(refusal.find(expected), std::string::npos) << refusal;
  };
  EXPECT_EQ(refusalOf("footbot", "<joints/><holders/>", "<footbot_turret_state/><joint_states/>"), "");
  expectRefusal(refusalOf("footbot", "<footbot_turret/><joints/>"),
                "the device 'footbot_turret' commands the robot's joint 'turret' already");
  expectRefusal(refusalOf("footbot", "<footbot_gripper/><holders/>"),
                "the device 'footbot_gripper' commands the robot's holder 'gripper' already");
  expectRefusal(refusalOf("eyebot", "<joints/>"), "uses the actuator 'joints', and a eyebot has no joints");
  expectRefusal(refusalOf("eyebot", "", "<joint_states/>"),
                "found the device 'joint_states' on a eyebot, allowed: on robots with joints");
  expectRefusal(refusalOf("handbot", "<joints/>"), "device 'joints' cannot be simulated in a plane");
}

}  // namespace
}  // namespace swarmanoid::test

REGISTER_CONTROLLER(swarmanoid::test::TestParts, "test_parts")
