// The conformance test of any robot with a differential drive, with a wall as its only reference: it detects a wrongly
// wired drive, and names the failed expectation.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <variant>

#include "miswired_robot.hpp"
#include "swarmanoid_experiment_files/read_experiment.hpp"
#include "swarmanoid_interface/devices/differential_drive.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/plugin_library.hpp"

namespace swarmanoid::test {
namespace {

/// A footbot with the devices of any robot; a wall is 0.4 m to the right of its centre.
constexpr const char* kExperiment = R"(<?xml version="1.0"?>
<ahss-config>
  <framework>
    <clocktick>100</clocktick>
    <maxclock>600</maxclock>
  </framework>
  <controllers>
    <conformance id="test" library="conformance">
      <actuators><differential_drive/></actuators>
      <sensors><proximity/></sensors>
      <parameters><wall_distance>0.4</wall_distance></parameters>
    </conformance>
  </controllers>
  <arena size="4,4,1" optimization="2D">
    <footbot id="r">
      <position>2, 2, 0</position>
      <orientation>0, 0, 0</orientation>
      <controller>test</controller>
    </footbot>
    <block id="wall">
      <position>2, 1.55, 0.15</position>
      <orientation>0, 0, 0</orientation>
      <size>1.5, 0.1, 0.3</size>
    </block>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics>
    <engine id="ground">
      <entity id="r"/>
      <entity id="wall"/>
    </engine>
  </arena_physics>
  <visualisations><verdict_monitor id="verdict" library="verdict_monitor"/></visualisations>
</ahss-config>
)";

/// Returns the verdict of the robot if its drive is wired like that.
std::string verdictWith(const Miswiring& miswiring) {
  loadBuiltInPlugins();
  Simulation simulation(parseExperiment(kExperiment, "drive.xml", {{"arena.r.controller.source", "remote"}}));
  simulation.start();
  MiswiredRobot robot(simulation, "r", miswiring);
  while (!simulation.isFinished()) {
    simulation.tick();
  }
  const Metrics metrics = simulation.metrics();
  return std::get<std::string>(metrics.at("r"));
}

/// @param change function that changes the speeds of the left and the right wheel over the ground [m/s]
template <class Change>
Miswiring wireWheels(Change change) {
  return wire<DifferentialDrive>([change](DifferentialDrive& drive) {
    const double difference = 0.5 * FootbotWheels::kSeparation * drive.turn_rate;
    double left = drive.speed - difference;
    double right = drive.speed + difference;
    change(left, right);
    drive.drive(0.5 * (left + right), (right - left) / FootbotWheels::kSeparation);
  });
}

constexpr const char* kFailed = "conformance test failed: differential_drive (differential_drive: ";
constexpr const char* kNoWall = "driving to the wall until something is near: not within 12.000 s";

void expectFailure(const Miswiring& miswiring, const std::string& why) {
  const std::string verdict = verdictWith(miswiring);
  EXPECT_EQ(0U, verdict.find(kFailed + why)) << verdict;
}

TEST(ConformanceDriveTest, PassesADriveThatIsWiredRightly) {
  EXPECT_EQ("passed", verdictWith(wireWheels([](double&, double&) {})));
}

TEST(ConformanceDriveTest, FindsWheelsThatAreSwapped) {
  expectFailure(wireWheels([](double& left, double& right) { std::swap(left, right); }), kNoWall);
}

TEST(ConformanceDriveTest, FindsADriveThatGoesBackwards) {
  expectFailure(wire<DifferentialDrive>([](DifferentialDrive& drive) { drive.speed = -drive.speed; }), kNoWall);
}

/// The robot drives on a circle of 0.21 m, which does not come near the wall.
TEST(ConformanceDriveTest, FindsALeftWheelThatTurnsTooSlowly) {
  expectFailure(wireWheels([](double& left, double&) { left *= 0.5; }), kNoWall);
}

/// On a circle to the right the robot reaches the wall, but does not face it.
TEST(ConformanceDriveTest, FindsARightWheelThatTurnsTooSlowly) {
  expectFailure(wireWheels([](double&, double& right) { right *= 0.5; }), "bearing of the wall ahead: ");
}

/// From 0.4 m to 0.13 m, where a footbot reads 0.15, it takes 9 s at 0.03 m/s: as if the distance were 0.45 m.
TEST(ConformanceDriveTest, FindsADriveThatIsTooSlowThoughItTurnsAsItShould) {
  expectFailure(wire<DifferentialDrive>([](DifferentialDrive& drive) { drive.speed *= 0.6; }), "way to the wall: 0.45");
}

}  // namespace
}  // namespace swarmanoid::test
