// The conformance test of any robot with microphones, with a sounding loudspeaker: it detects wrongly wired
// microphones, and names the failed expectation.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "miswired_robot.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/microphones.hpp"
#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid::test {
namespace {

/// A footbot with the devices of any robot; a loudspeaker sounds 1.7 m away, behind it on its left.
std::string experimentWith(const std::string& parameters) {
  return R"(<?xml version="1.0"?>
<ahss-config>
  <framework>
    <clocktick>100</clocktick>
    <maxclock>200</maxclock>
  </framework>
  <controllers>
    <conformance id="test" library="conformance">
      <actuators><differential_drive/></actuators>
      <sensors><microphones/></sensors>
      <parameters>)" +
         parameters + R"(</parameters>
    </conformance>
  </controllers>
  <arena size="4,4,1" optimization="2D">
    <footbot id="r">
      <position>2, 2, 0</position>
      <orientation>0, 0, 40</orientation>
      <controller>test</controller>
    </footbot>
    <loudspeaker id="horn">
      <position>1.1, 3.4, 0.3</position>
      <orientation>0, 0, 0</orientation>
    </loudspeaker>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="r"/></engine></arena_physics>
  <visualisations><verdict_monitor id="verdict" library="verdict_monitor"/></visualisations>
</ahss-config>
)";
}

/// Returns the verdict of the robot if its microphones, or its drive, are wired like that.
std::string verdictWith(const Miswiring& miswiring, const std::string& parameters = "<sound>true</sound>") {
  loadBuiltInPlugins();
  Simulation simulation(
      parseExperiment(experimentWith(parameters), "hearing.xml", {{"arena.r.controller.source", "remote"}}));
  simulation.start();
  MiswiredRobot robot(simulation, "r", miswiring);
  while (!simulation.isFinished()) {
    simulation.tick();
  }
  return std::get<std::string>(simulation.metrics().at("r"));
}

/// @param change function that changes the readings
template <class Change>
Miswiring wireMicrophones(Change change) {
  return wire<Microphones>([change, kept = std::make_shared<std::vector<Microphone>>()](Microphones& sensor) {
    kept->assign(sensor.sensors.begin(), sensor.sensors.end());
    change(*kept, sensor.loudest);
    sensor.sensors = Span<const Microphone>(kept->data(), kept->size());
  });
}

using Ears = std::vector<Microphone>;

void expectFailure(const Miswiring& miswiring, const std::string& why) {
  const std::string verdict = verdictWith(miswiring);
  EXPECT_EQ(0U, verdict.find("conformance test failed: " + why)) << verdict;
}

TEST(ConformanceMicrophonesTest, PassesMicrophonesThatAreWiredRightly) {
  EXPECT_EQ("passed", verdictWith(wireMicrophones([](Ears&, LoudestSound&) {})));
}

TEST(ConformanceMicrophonesTest, FindsABearingThatIsClockwise) {
  expectFailure(wireMicrophones([](Ears&, LoudestSound& loudest) { loudest.bearing = -loudest.bearing; }),
                "microphones_hear (microphones_hear: not true: levels rise towards its bearing, ");
}

TEST(ConformanceMicrophonesTest, FindsABearingInDegrees) {
  expectFailure(wireMicrophones([](Ears&, LoudestSound& loudest) { loudest.bearing *= 57.29578F; }), "microphones_");
}

TEST(ConformanceMicrophonesTest, FindsMicrophonesFromTheOtherSide) {
  expectFailure(wireMicrophones([](Ears& ears, LoudestSound&) { std::swap(ears[1].level, ears[3].level); }),
                "microphones_hear (microphones_hear: not true: levels rise towards its bearing, ");
}

TEST(ConformanceMicrophonesTest, FindsABearingThatDoesNotTurn) {
  expectFailure(wireMicrophones([first = std::make_shared<std::vector<float>>()](Ears&, LoudestSound& loudest) {
                  if (loudest.frequency > 0.0F) {
                    first->push_back(loudest.bearing);
                    loudest.bearing = first->front();
                  }
                }),
                "microphones_turn (microphones_turn: bearing of the loudest source after a turn to the left: ");
}

TEST(ConformanceMicrophonesTest, WithoutASoundThereIsNothingToJudge) {
  loadBuiltInPlugins();
  Simulation simulation(parseExperiment(experimentWith(""), "hearing.xml"));
  simulation.start();
  while (!simulation.isFinished()) {
    simulation.tick();
  }
  const Space& space = simulation.space();
  std::string unchecked;
  for (const auto& [key, value] : space.robots[space.entities.find("r")]->debugValues()) {
    unchecked = key == "unchecked" ? value : unchecked;
  }
  const std::string expected =
      "microphones_hear (nothing sounds here (sound is false)); microphones_turn (nothing sounds here (sound is "
      "false))";
  EXPECT_NE(unchecked.find(expected), std::string::npos) << unchecked;
  ASSERT_EQ(1U, simulation.failures().size());
  EXPECT_EQ(0U, simulation.failures()[0].reason.find("conformance test failed: nothing could be checked"))
      << simulation.failures()[0].reason;
}

}  // namespace
}  // namespace swarmanoid::test
