// Climbing handbots: the example, ropes and arms at handovers between engines, devices that are idle in a plane.
#include <gtest/gtest.h>

#include "handover_world.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid::test {
namespace {

// Indices of holders in the handbot's model.
constexpr std::size_t kLeftHand = 0;
constexpr std::size_t kRope = 2;

Experiment climbing() {
  loadBuiltInPlugins();
  return readExperiment(findShared("swarmanoid_experiments", "experiments/climbing.xml"));
}

/// @param members ids in the file; those of distributed entities without their numbers
/// @param first whether the engine comes before all others, so that it moves its members
void addEngine(Experiment& experiment, const std::string& label, const std::string& id,
               const std::vector<std::string>& members, bool first) {
  EngineDescription engine;
  engine.label = label;
  engine.id = id;
  engine.parameters = Configuration(label, "", {});
  experiment.engines.push_back(engine);
  MappingDescription mapping;
  mapping.engine = id;
  for (const std::string& member : members) {
    mapping.members.push_back({member, {}, {}});
  }
  experiment.mappings.insert(first ? experiment.mappings.begin() : experiment.mappings.end(), mapping);
}

std::unique_ptr<Simulation> start(Experiment experiment) {
  auto simulation = std::make_unique<Simulation>(std::move(experiment));
  simulation->start();
  return simulation;
}

Row rowOf(const Simulation& simulation, const std::string& name) { return simulation.space().entities.find(name); }

std::string stateOf(const Simulation& simulation) {
  const auto& values = simulation.space().robots[rowOf(simulation, "hb_1")]->debugValues();
  return values.empty() ? "" : values[0].second;
}

void runUntil(Simulation& simulation, const std::string& state) {
  while (!simulation.isFinished() && stateOf(simulation) != state) {
    simulation.tick();
  }
  ASSERT_EQ(stateOf(simulation), state);
}

void expectTheBoxIsDown(Simulation& simulation) {
  runUntil(simulation, "done");
  tick(simulation, 5);
  const Attachments& attachments = simulation.space().attachments;
  const Row robot = rowOf(simulation, "hb_1");
  EXPECT_EQ(attachments.of(robot, kLeftHand).held, rowOf(simulation, "box_1"));
  EXPECT_FALSE(attachments.isAttached(robot, kRope));
  EXPECT_NEAR(poseOf(simulation, "hb_1").position.z(), 0.0, 2e-3);
  EXPECT_LT(poseOf(simulation, "box_1").position.z(), 0.5);  // its initial height is 0.74 m
}

TEST(ClimbingTest, TheHandbotBringsTheBoxDown) { expectTheBoxIsDown(*start(climbing())); }

TEST(ClimbingTest, WhoeverHangsAndIsNotCommandedAnyMoreKeepsHanging) {
  auto simulation = start(climbing());
  runUntil(*simulation, "climbing");
  while (poseOf(*simulation, "hb_1").position.z() < 0.2) {
    simulation->tick();
  }
  simulation->apply(SetCommandSource{"hb_1", CommandSource::kNone});
  tick(*simulation, 20);
  const double height = poseOf(*simulation, "hb_1").position.z();
  EXPECT_GT(height, 0.2);
  EXPECT_TRUE(simulation->space().attachments.isAttached(rowOf(*simulation, "hb_1"), kRope));
  tick(*simulation, 50);
  EXPECT_NEAR(poseOf(*simulation, "hb_1").position.z(), height, 0.01);
}

TEST(ClimbingTest, FootbotsCarryItThereInTwoDimensions) {
  loadBuiltInPlugins();
  auto simulation = start(readExperiment(findShared("swarmanoid_experiments", "experiments/shelf_retrieval.xml")));
  ASSERT_EQ(moverOf(*simulation, "hb_1"), "ground");
  tick(*simulation, 100);
  EXPECT_EQ(simulation->space().structure.grippersOf(rowOf(*simulation, "hb_1")).size(), 2U);
  runUntil(*simulation, "shooting");
  EXPECT_TRUE(simulation->space().structure.grippersOf(rowOf(*simulation, "hb_1")).empty());
  // its sensor, 0.145 m ahead of its axis, detects the cabinet at 0.09 m; the carriers receive the message two ticks
  // later
  EXPECT_NEAR(poseOf(*simulation, "hb_1").position.x(), 2.5 - 0.145 - 0.09 + 0.015, 0.015);
  expectTheBoxIsDown(*simulation);
  EXPECT_EQ(moverOf(*simulation, "hb_1"), "space");
}

// Simulated by hand: arms and rope follow their commands, the wall ends at a rope length of 0.8 m, and the hand loses
// the object as soon as it is raised.
TEST(ClimbingTest, WhoLosesTheObjectAgainAndAgainComesDown) {
  constexpr auto kTick = std::chrono::milliseconds(100);
  Robot robot("hb_1", "handbot", 1);
  HandbotArms arms;
  HandbotHands hands;
  HandbotRope rope;
  HandbotArmsState arms_state;
  HandbotHandsState hands_state;
  HandbotRopeState rope_state{false, 1.3, 5.0};
  HandbotDistance distance;
  robot.provideActuator(HandbotArms::kType, &arms);
  robot.provideActuator(HandbotHands::kType, &hands);
  robot.provideActuator(HandbotRope::kType, &rope);
  robot.provideSensor(HandbotArmsState::kType, &arms_state);
  robot.provideSensor(HandbotHandsState::kType, &hands_state);
  robot.provideSensor(HandbotRopeState::kType, &rope_state);
  robot.provideSensor(HandbotDistance::kType, &distance);
  loadPluginLibrary("climbing", {}, {});
  const auto climber = makePlugin<Controller>(*Registry::instance().find(PluginKind::kController, "climbing"));
  climber->init(robot, {"parameters", "", {}});
  int losses = 0;
  std::string state;
  for (std::uint64_t tick = 0; tick < 3000 && state != "descending"; ++tick) {
    distance.value(0) = rope_state.length > 0.8 ? 0.07F : 0.29F;
    arms_state.joints[0].angle = arms.left.shoulder;
    rope_state.attached = rope.shot;
    rope_state.length -= 0.1 * rope.winding_speed;
    hands_state.left.holding = hands.left && state == "reaching";
    robot.startTick(tick, kEpoch + tick * kTick);
    climber->step(kEpoch + tick * kTick, kTick);
    const std::string before = state;
    state = robot.debugValues()[0].second;
    losses += before == "taking" ? 1 : 0;
  }
  EXPECT_EQ(state, "descending");
  EXPECT_EQ(losses, 5);
  EXPECT_FALSE(hands.left);
}

TEST(ClimbingTest, TheSameBitsAgainAndAfterAReset) {
  const auto expected = hashesOf(*start(climbing()), 150);
  auto again = start(climbing());
  EXPECT_EQ(hashesOf(*again, 150), expected);
  ASSERT_TRUE(again->space().attachments.isAttached(rowOf(*again, "hb_1"), kRope)) << "it hangs when it is reset";
  again->reset();
  EXPECT_EQ(hashesOf(*again, 150), expected);
}

/// State that a handover must keep bit for bit.
struct Kept {
  explicit Kept(const Simulation& simulation) {
    const Space& space = simulation.space();
    for (const char* name : {"hb_1", "box_1"}) {
      const Row row = space.entities.find(name);
      poses.push_back(space.entities.pose[row]);
      twists.push_back(space.entities.twist[row]);
    }
    const Row robot = space.entities.find("hb_1");
    joints.assign(space.joints[robot].begin(), space.joints[robot].end());
    rope = space.attachments.of(robot, kRope);
    hand = space.attachments.of(robot, kLeftHand);
  }
  void expectIn(const Simulation& simulation) const {
    const Kept now(simulation);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      EXPECT_EQ(now.poses[i].position, poses[i].position);
      EXPECT_EQ(now.poses[i].orientation.coeffs(), poses[i].orientation.coeffs());
      EXPECT_EQ(now.twists[i].linear, twists[i].linear);
      EXPECT_EQ(now.twists[i].angular, twists[i].angular);
    }
    for (std::size_t i = 0; i < joints.size(); ++i) {
      EXPECT_EQ(now.joints[i].angle, joints[i].angle);
      EXPECT_EQ(now.joints[i].speed, joints[i].speed);
    }
    EXPECT_EQ(now.rope.held, rope.held);
    EXPECT_EQ(now.rope.anchor, rope.anchor);
    EXPECT_EQ(now.rope.length, rope.length);
    EXPECT_EQ(now.hand.held, hand.held);
  }

  std::vector<Pose> poses;
  std::vector<Twist> twists;
  std::vector<JointState> joints;
  Attachment rope;
  Attachment hand;
};

TEST(ClimbingTest, RopeArmsAndHandsGoFromEngineToEngine) {
  Experiment experiment = climbing();
  addEngine(experiment, "dynamics3d", "other", {"ceiling", "cabinet", "box", "hb"}, false);
  auto simulation = start(experiment);
  runUntil(*simulation, "climbing");
  const auto goAndReturn = [&](int times, const std::string& state) {
    for (int i = 0; i < 2 * times; ++i) {
      const std::string target = i % 2 == 0 ? "other" : "space";
      const Kept before(*simulation);
      simulation->apply(HandOverEntity{"hb_1", target});
      ASSERT_EQ(moverOf(*simulation, "hb_1"), target);
      before.expectIn(*simulation);
      tick(*simulation);
      ASSERT_EQ(stateOf(*simulation), state);
      ASSERT_TRUE(simulation->space().attachments.isAttached(rowOf(*simulation, "hb_1"), kRope));
    }
  };
  goAndReturn(15, "climbing");
  const double length = simulation->space().attachments.of(rowOf(*simulation, "hb_1"), kRope).length;
  EXPECT_LT(length, 2.15);  // wound all the time, with increasing speed, from 2.21 m
  runUntil(*simulation, "descending");
  goAndReturn(10, "descending");
  EXPECT_EQ(moverOf(*simulation, "box_1"), "space");  // it was handed over with the handbot, there and back
  expectTheBoxIsDown(*simulation);
}

TEST(ClimbingTest, WhoIsMovedFromOutsideLetsGo) {
  auto simulation = start(climbing());
  runUntil(*simulation, "descending");
  simulation->apply(MoveEntity{"hb_1", {{1.0, 1.0, 0.0}, Eigen::Quaterniond::Identity()}});
  EXPECT_FALSE(simulation->space().attachments.isAttached(rowOf(*simulation, "hb_1")));
  runUntil(*simulation, "done");
  EXPECT_LT((poseOf(*simulation, "hb_1").position - Eigen::Vector3d(1.0, 1.0, 0.0)).norm(), 5e-3);
  tick(*simulation, 20);
  EXPECT_LT(poseOf(*simulation, "box_1").position.z(), 0.1) << "it fell";
}

TEST(ClimbingTest, WithoutItsCeilingItFalls) {
  auto simulation = start(climbing());
  runUntil(*simulation, "reaching");
  simulation->apply(DeleteEntity{"ceiling"});
  EXPECT_FALSE(simulation->space().attachments.isAttached(rowOf(*simulation, "hb_1"), kRope));
  tick(*simulation, 20);
  EXPECT_LT(poseOf(*simulation, "hb_1").position.z(), 0.2);
}

TEST(ClimbingTest, WhatTheRopeHoldsOnToMustBeThere) {
  Experiment experiment = climbing();
  addEngine(experiment, "dynamics3d", "other", {"hb"}, false);
  auto simulation = start(experiment);
  runUntil(*simulation, "climbing");
  try {
    simulation->apply(HandOverEntity{"hb_1", "other"});
    FAIL() << "was accepted";
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()),
              "handbot 'hb_1' cannot be handed over to engine 'other': its rope holds on to 'ceiling', which "
              "is not in this engine");
  }
}

TEST(ClimbingTest, DevicesStandIdleInAPlaneUntilTheHandover) {
  Experiment experiment = climbing();
  addEngine(experiment, "dynamics2d", "ground", {"hb"}, true);
  auto simulation = start(experiment);
  ASSERT_EQ(moverOf(*simulation, "hb_1"), "ground");
  tick(*simulation, 3);
  simulation->apply(HandOverEntity{"hb_1", "space"});
  tick(*simulation);
  simulation->apply(HandOverEntity{"hb_1", "ground"});
  tick(*simulation);
  EXPECT_NE(eventsIn(*simulation).find("from space to ground; idle there: handbot_arms, handbot_hands, handbot_rope; "),
            std::string::npos)
      << eventsIn(*simulation);
  tick(*simulation, 30);
  EXPECT_EQ(stateOf(*simulation), "shooting");
  EXPECT_FALSE(simulation->space().attachments.isAttached(rowOf(*simulation, "hb_1")));
  simulation->apply(HandOverEntity{"hb_1", "space"});
  expectTheBoxIsDown(*simulation);
}

TEST(ClimbingTest, APlaneAloneIsRefused) {
  Experiment experiment = climbing();
  addEngine(experiment, "kinematics2d", "ground", {"hb"}, true);
  auto& members = experiment.mappings.back().members;
  members.erase(members.end() - 1);
  try {
    start(experiment);
    FAIL() << "was accepted";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what())
                  .find("handbot 'hb_1' in engine 'ground': device 'handbot_arms' cannot be simulated in a plane"),
              std::string::npos)
        << error.what();
  }
}

TEST(ClimbingTest, WhoHangsOnARopeCannotGoIntoAPlane) {
  Experiment experiment = climbing();
  addEngine(experiment, "kinematics2d", "ground", {"hb"}, false);
  auto simulation = start(experiment);
  runUntil(*simulation, "reaching");
  const std::uint64_t hash = simulation->stateHash();
  EXPECT_THROW(simulation->apply(HandOverEntity{"hb_1", "ground"}), ConfigError);
  EXPECT_EQ(simulation->stateHash(), hash);
}

}  // namespace
}  // namespace swarmanoid::test
