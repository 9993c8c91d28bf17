// The conformance test of odometry, positioning, encoders and the battery gauge: it passes with correct wiring, in each
// engine and with coarse encoders, and detects wrong units.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "conformance_world.hpp"
#include "swarmanoid_interface/devices/battery.hpp"
#include "swarmanoid_interface/devices/odometry.hpp"
#include "swarmanoid_interface/devices/positioning.hpp"
#include "swarmanoid_interface/devices/wheel_encoders.hpp"

namespace swarmanoid::test {
namespace {

/// A footbot with the devices of any robot, turned so that its frame differs from the world's.
constexpr const char* kRobot = R"(<?xml version="1.0"?>
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>600</maxclock></framework>
  <controllers>
    <conformance id="test" library="conformance">
      <actuators><differential_drive/></actuators>
      <sensors><odometry/><positioning/><wheel_encoders/><battery/></sensors>
    </conformance>
  </controllers>
  <arena size="5,5,1" optimization="2D">
    <footbot id="r">
      <position>2, 2, 0</position><orientation>0, 0, 40</orientation><controller>test</controller>
      <battery>true</battery>
    </footbot>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="r"/></engine></arena_physics>
  <visualisations><verdict_monitor id="verdict" library="verdict_monitor"/></visualisations>
</ahss-config>
)";

TEST(ConformanceWheelsTest, PassesWhatIsWiredRightlyInEachEngine) {
  for (const std::string engine : {"kinematics2d", "dynamics2d", "dynamics3d"}) {
    std::string text = kRobot;
    replace(text, "<kinematics2d ", "<" + engine + " ");
    const auto simulation = start(text);
    EXPECT_EQ("passed", fullVerdictsOf(*simulation)["r"]) << engine;
    EXPECT_EQ("battery_plausible, battery_drains, odometry, positioning, wheel_encoders",
              debugOf(*simulation, "r", "passed"));
  }
}

TEST(ConformanceWheelsTest, PassesCoarseEncoders) {
  std::string text = kRobot;
  replace(text, "<wheel_encoders/>", "<wheel_encoders><ticks_per_turn>60</ticks_per_turn></wheel_encoders>");
  replace(text, "<odometry/>", "<odometry><ticks_per_turn>60</ticks_per_turn></odometry>");
  EXPECT_EQ("passed", fullVerdictsOf(*start(text))["r"]);
}

TEST(ConformanceWheelsTest, FindsOdometryThatIsWrong) {
  const auto expect = [](auto change, const std::string& why) {
    expectFailure(kRobot, "r", wire<Odometry>(change), "odometry (odometry: " + why);
  };
  expect([](Odometry& odometry) { std::swap(odometry.x, odometry.y); }, "way ");
  expect([](Odometry& odometry) { odometry.x *= 100.0; }, "way ahead by odometry: ");
  expect([](Odometry& odometry) { odometry.heading *= -1.0; }, "turned by odometry: ");
  expect([](Odometry& odometry) { odometry.speed *= -1.0; }, "way by the speeds of odometry: -0.1");
  expect([](Odometry& odometry) { odometry.turn_rate *= kDegrees; }, "turned by the turn rates of odometry: 48.");
}

TEST(ConformanceWheelsTest, FindsPositioningThatIsWrong) {
  const auto expect = [](auto change, const std::string& why) {
    expectFailure(kRobot, "r", wire<Positioning>(change), "positioning (positioning: " + why);
  };
  expect([](Positioning& said) { said.position *= 100.0; }, "way ahead by positioning: ");
  expect([](Positioning& said) { said.position.y() *= -1.0; }, "way ");  // left-handed
  expect([](Positioning& said) { said.heading *= kDegrees; }, "");
  expect([](Positioning& said) { said.heading += 0.7; }, "way ");
  expect([](Positioning& said) { said.pitch = 0.2 * said.heading; }, "pitch by positioning: ");
}

TEST(ConformanceWheelsTest, FindsEncodersThatAreWrong) {
  const auto expect = [](auto change, const std::string& why) {
    expectFailure(kRobot, "r", wire<WheelEncoders>(change), "wheel_encoders (wheel_encoders: " + why);
  };
  expect(
      [](WheelEncoders& encoders) {
        for (double* value : {&encoders.left.turned, &encoders.left.step, &encoders.left.speed}) {
          *value *= -1.0;
        }
      },
      "not true: both wheels have turned the way that it drove");
  expect([](WheelEncoders& encoders) { encoders.left.turned *= kDegrees; }, "the left wheel has turned by: ");
  expect([](WheelEncoders& encoders) { encoders.right.speed *= 60.0 / 6.283185307179586; },  // revolutions per minute
         "the right wheel has turned by: ");
}

TEST(ConformanceWheelsTest, FindsAGaugeInOtherUnits) {
  expectFailure(kRobot, "r", wire<Battery>([](Battery& battery) {
                  battery.charge /= 3600.0F;  // in Wh
                  battery.capacity /= 3600.0F;
                }),
                "battery_drains (battery_drains: charge that is used: 0.00");
  expectFailure(kRobot, "r", wire<Battery>([](Battery& battery) { battery.power *= 1000.0F; }),
                "battery_drains (battery_drains: charge that is used: ");
  expectFailure(kRobot, "r", wire<Battery>([](Battery& battery) { battery.power *= -1.0F; }), "battery_drains");
}

}  // namespace
}  // namespace swarmanoid::test
