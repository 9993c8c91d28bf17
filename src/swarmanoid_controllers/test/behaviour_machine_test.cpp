// The behaviour machine: frequency of its transitions, commands of its behaviours, and rejected parameters.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../src/behaviour_machine/machine.hpp"
#include "elements.hpp"
#include "swarmanoid_interface/controller.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/ground.hpp"
#include "swarmanoid_interface/devices/light.hpp"
#include "swarmanoid_interface/devices/proximity.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "swarmanoid_interface/testing/count_allocations.hpp"

namespace swarmanoid {
namespace {

using test::element;
using test::refusalOf;
using test::value;

Configuration state(const std::string& name, const std::string& behaviour, std::vector<Configuration> more = {}) {
  more.insert(more.begin(), value("behaviour", behaviour));
  return element(name, more);
}

Configuration transition(const std::string& name, const std::string& from, const std::string& to,
                         const std::string& condition, std::vector<Configuration> more = {}) {
  more.insert(more.begin(), {value("from", from), value("to", to), value("condition", condition)});
  return element(name, more);
}

Configuration machineOf(const std::vector<Configuration>& states, const std::vector<Configuration>& transitions) {
  return element("parameters", {element("states", states), element("transitions", transitions)});
}

/// Share of 4000 steps in which a transition with that condition is taken.
double shareTaken(const std::string& condition, const std::vector<Configuration>& more, const Surroundings& around) {
  Machine machine(machineOf({state("stay", "stop")}, {transition("go", "stay", "stay", condition, more)}));
  RandomStream random(1, 2);
  constexpr int kSteps = 4000;
  int taken = 0;
  for (int i = 0; i < kSteps; ++i) {
    random.startTick(static_cast<std::uint64_t>(i));
    taken += machine.advance(around, random) ? 1 : 0;
  }
  return static_cast<double>(taken) / kSteps;
}

TEST(MachineTest, TransitionsAreTakenAsOftenAsTheirConditionsSay) {
  const double tolerance = 0.03;  // four standard deviations of a share of 4000
  EXPECT_EQ(shareTaken("black_floor", {}, {FloorShade::kBlack, 0}), 1.0);
  EXPECT_EQ(shareTaken("black_floor", {}, {FloorShade::kGray, 0}), 0.0);
  EXPECT_EQ(shareTaken("white_floor", {}, {FloorShade::kGray, 0}), 0.0);
  EXPECT_NEAR(shareTaken("gray_floor", {value("probability", "0.3")}, {FloorShade::kGray, 0}), 0.3, tolerance);
  EXPECT_NEAR(shareTaken("always", {value("probability", "0.6")}, {FloorShade::kWhite, 0}), 0.6, tolerance);
  // 1 / (1 + e^(2 (3 - 4))) = 0.8808
  const std::vector<Configuration> three{value("count", "3"), value("steepness", "2")};
  EXPECT_NEAR(shareTaken("many_neighbours", three, {FloorShade::kGray, 4}), 0.8808, tolerance);
  EXPECT_NEAR(shareTaken("few_neighbours", three, {FloorShade::kGray, 4}), 0.1192, tolerance);
  EXPECT_NEAR(shareTaken("few_neighbours", three, {FloorShade::kGray, 3}), 0.5, tolerance);
}

TEST(MachineTest, BeginsInTheFirstStateAndTakesTheFirstTransitionThatHolds) {
  Machine machine(machineOf({state("a", "stop"), state("b", "stop"), state("c", "stop")},
                            {transition("back", "b", "a", "always"), transition("not_now", "a", "a", "white_floor"),
                             transition("on", "a", "b", "black_floor"), transition("else", "a", "c", "always")}));
  RandomStream random(1, 2);
  EXPECT_EQ(machine.state().name, "a");
  EXPECT_TRUE(machine.advance({FloorShade::kBlack, 0}, random));
  EXPECT_EQ(machine.state().name, "b");
  EXPECT_TRUE(machine.advance({FloorShade::kGray, 0}, random));
  EXPECT_EQ(machine.state().name, "a") << "one transition a step";
  EXPECT_TRUE(machine.advance({FloorShade::kGray, 0}, random));
  EXPECT_EQ(machine.state().name, "c");
  EXPECT_FALSE(machine.advance({FloorShade::kGray, 0}, random)) << "none leads from there";
  machine.reset();
  EXPECT_EQ(machine.state().name, "a");
}

TEST(MachineTest, WhatIsWrongIsRefused) {
  const auto refusal = [](const Configuration& parameters) { return refusalOf([&] { Machine machine(parameters); }); };
  const Configuration stop = state("a", "stop");
  EXPECT_EQ(refusal(element("parameters", {})), "file.xml:7: <parameters> has no 'states', which the machine needs");
  EXPECT_EQ(refusal(machineOf({}, {})), "file.xml:7: states: found nothing in it, allowed: at least one");
  EXPECT_EQ(refusal(machineOf({state("a", "phototaxi")}, {})),
            "file.xml:8: a: found the behaviour 'phototaxi', allowed: exploration, stop, phototaxis, anti_phototaxis, "
            "attraction, "
            "repulsion; did you mean 'phototaxis'?");
  EXPECT_EQ(refusal(machineOf({stop}, {transition("t", "a", "b", "always")})),
            "file.xml:8: t: to: found the state 'b', allowed: a");
  EXPECT_EQ(refusal(machineOf({stop}, {transition("t", "a", "a", "grey_floor")})),
            "file.xml:8: t: found the condition 'grey_floor', allowed: black_floor, gray_floor, white_floor, "
            "many_neighbours, "
            "few_neighbours, always; did you mean 'gray_floor'?");
  EXPECT_NE(refusal(machineOf({stop, stop}, {})), "") << "a name twice";
  EXPECT_NE(refusal(machineOf({state("a", "stop", {value("turning", "3")})}, {})), "") << "of another behaviour";
  EXPECT_NE(refusal(machineOf({stop}, {transition("t", "a", "a", "many_neighbours")})), "") << "of how many";
  EXPECT_NE(refusal(machineOf({stop}, {transition("t", "a", "a", "always", {value("probability", "1.1")})})), "");
}

/// A robot with two wheels whose readings the test sets.
class Forager {
 public:
  explicit Forager(const Configuration& parameters) {
    proximity.sensors = obstacles;
    light.sensors = lights;
    ground.sensors = spots;
    robot.provideSensor(Proximity::kType, &proximity);
    robot.provideSensor(Light::kType, &light);
    robot.provideSensor(Ground::kType, &ground);
    robot.provideSensor(RangeAndBearingReceived::kType, &received);
    robot.provideActuator(DifferentialDrive::kType, &drive);
    robot.provideActuator(RangeAndBearing::kType, &transmitter);
    controller = makePlugin<Controller>(*Registry::instance().find(PluginKind::kController, "behaviour_machine"));
    controller->init(robot, parameters);
  }
  void step() {
    robot.startTick(tick++, kEpoch);
    controller->step(kEpoch, std::chrono::milliseconds(100));
  }

  Robot robot{"forager", "any", 1};
  std::vector<ProximityReading> obstacles{{0.0F, 0.5F}, {0.0F, -0.5F}};
  std::vector<LightReading> lights{{0.0F, 0.5F}, {0.0F, -0.5F}};
  std::vector<GroundSpot> spots{{0.5F, 0.0F, 0.0F}, {0.5F, 0.0F, 0.0F}, {0.5F, 0.0F, 0.0F}};
  Proximity proximity;
  Light light;
  Ground ground;
  RangeAndBearingReceived received;
  RangeAndBearing transmitter;
  DifferentialDrive drive;
  std::shared_ptr<Controller> controller;
  std::uint64_t tick = 1;
};

TEST(BehaviourMachineTest, AResetEndsATurn) {
  const Configuration parameters = machineOf({state("search", "exploration", {value("turning", "100")})}, {});
  for (const bool is_reset : {false, true}) {
    Forager forager(parameters);
    forager.obstacles[0].value = 0.5F;
    forager.step();
    ASSERT_EQ(forager.drive.turn_rate, -1.5);
    forager.obstacles[0].value = 0.0F;
    if (is_reset) {
      forager.controller->reset();
      EXPECT_EQ(forager.drive.turn_rate, 0.0);
    }
    forager.step();
    EXPECT_EQ(forager.drive.turn_rate, is_reset ? 0.0 : -1.5) << "the turn that is drawn is longer than one step";
  }
}

TEST(BehaviourMachineTest, PhototaxisTurnsToTheLightAndAwayFromWhatIsNear) {
  Forager forager(machineOf({state("home", "phototaxis")}, {}));
  forager.step();
  EXPECT_NEAR(forager.drive.speed, 0.15, 1e-12) << "in the dark straight on";
  EXPECT_NEAR(forager.drive.turn_rate, 0.0, 1e-12);
  forager.lights[0].value = 0.2F;
  forager.step();
  EXPECT_NEAR(forager.drive.turn_rate, 2.0 * 0.5, 1e-6) << "2/s times the bearing of the light";
  // unit vector to the light at 0.5, minus five times 0.1 at 0.5: half of it remains; with 0.3 it turns round
  forager.obstacles[0].value = 0.1F;
  forager.step();
  EXPECT_NEAR(forager.drive.turn_rate, 2.0 * 0.5, 1e-6);
  forager.obstacles[0].value = 0.3F;
  forager.step();
  EXPECT_NEAR(forager.drive.turn_rate, -1.5, 1e-12) << "behind on the right, as fast as it turns";
}

TEST(BehaviourMachineTest, AntiPhototaxisRepulsionAndAttractionAreAboutTheirVectors) {
  Forager away(machineOf({state("out", "anti_phototaxis")}, {}));
  away.lights[0].value = 0.2F;
  away.step();
  EXPECT_NEAR(away.drive.turn_rate, -1.5, 1e-12);
  // 1 / (1 + 1) at 0.2, and 1 / (1 + 3) at -1.1
  const std::vector<RangeAndBearingMessage> messages{{1.0F, 0.2F, 0.0F, {}}, {3.0F, -1.1F, 0.0F, {}}};
  const double bearing =
      std::atan2(0.5 * std::sin(0.2) - 0.25 * std::sin(1.1), 0.5 * std::cos(0.2) + 0.25 * std::cos(1.1));
  Forager together(machineOf({state("in", "attraction")}, {}));
  together.received.messages = messages;
  together.step();
  EXPECT_NEAR(together.drive.turn_rate, 2.0 * bearing, 1e-6);
  EXPECT_TRUE(together.transmitter.sends);
  Forager apart(machineOf({state("out", "repulsion")}, {}));
  apart.received.messages = messages;
  apart.step();
  EXPECT_NEAR(apart.drive.turn_rate, 1.5, 1e-12) << "they are ahead on the right, so it turns round over the left";
}

TEST(BehaviourMachineTest, ExplorationDrivesStraightAndTurnsForSomeStepsAwayFromWhatIsAhead) {
  constexpr int kMost = 7;
  Forager forager(machineOf({state("search", "exploration", {value("turning", std::to_string(kMost))})}, {}));
  forager.step();
  EXPECT_EQ(forager.drive.speed, 0.15);
  EXPECT_EQ(forager.drive.turn_rate, 0.0);
  std::vector<int> turns;
  for (int i = 0; i < 200; ++i) {
    forager.obstacles[0].value = 0.5F;
    forager.step();
    ASSERT_EQ(forager.drive.turn_rate, -1.5) << "the obstacle is on the left";
    forager.obstacles[0].value = 0.0F;
    int steps = 0;
    for (; forager.drive.turn_rate != 0.0; ++steps) {
      forager.step();
    }
    turns.push_back(steps);
  }
  EXPECT_EQ(*std::min_element(turns.begin(), turns.end()), 1);
  EXPECT_EQ(*std::max_element(turns.begin(), turns.end()), kMost);
}

TEST(BehaviourMachineTest, TheFloorIsAsMostOfItsSensorsSay) {
  Forager forager(machineOf({state("search", "exploration"), state("stay", "stop")},
                            {transition("found", "search", "stay", "black_floor")}));
  forager.spots[0].value = 0.1F;
  forager.step();
  EXPECT_EQ(forager.drive.speed, 0.15) << "one of three";
  forager.spots[2].value = 0.1F;
  forager.step();
  EXPECT_EQ(forager.drive.speed, 0.0);
  EXPECT_EQ(forager.robot.debugValues().front().second, "stay");
}

TEST(BehaviourMachineTest, OnlyWhatTheMachineAsksForMustBeThere) {
  Robot robot("bare", "any", 1);
  Proximity proximity;
  DifferentialDrive drive;
  robot.provideSensor(Proximity::kType, &proximity);
  robot.provideActuator(DifferentialDrive::kType, &drive);
  const auto controller =
      makePlugin<Controller>(*Registry::instance().find(PluginKind::kController, "behaviour_machine"));
  EXPECT_NO_THROW(controller->init(robot, machineOf({state("search", "exploration")}, {})));
  EXPECT_THROW(controller->init(robot, machineOf({state("home", "phototaxis")}, {})), DeviceError);
}

TEST(BehaviourMachineTest, AStepAllocatesNothing) {
  Forager forager(machineOf({state("search", "exploration"), state("home", "phototaxis")},
                            {transition("found", "search", "home", "black_floor", {value("probability", "0.5")}),
                             transition("lost", "home", "search", "always", {value("probability", "0.5")})}));
  forager.spots[0].value = forager.spots[1].value = 0.0F;
  for (int i = 0; i < 20; ++i) {
    forager.step();
  }
  const long before = heap_allocations;
  for (int i = 0; i < 20; ++i) {
    forager.step();
  }
  EXPECT_EQ(heap_allocations, before);
}

}  // namespace
}  // namespace swarmanoid
