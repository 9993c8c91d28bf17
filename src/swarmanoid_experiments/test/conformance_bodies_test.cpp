// The conformance test of the environment sensors of handbots and eyebots, and of batteries: each wrongly wired device
// is detected and named. Correct wiring is tested in conformance_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "conformance_world.hpp"
#include "swarmanoid_interface/devices/battery.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_altitude.hpp"
#include "swarmanoid_interface/devices/eyebot_distance.hpp"
#include "swarmanoid_interface/devices/eyebot_position.hpp"
#include "swarmanoid_interface/devices/eyebot_pressure.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_distance.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_proximity.hpp"
#include "swarmanoid_interface/devices/handbot_vacuum.hpp"

namespace swarmanoid::test {
namespace {

void expectOnHandbot(const Miswiring& miswiring, const std::string& why) {
  expectFailure(conformanceText(), "hb", miswiring, why);
}
void expectOnEyebot(const Miswiring& miswiring, const std::string& why) {
  expectFailure(conformanceText(), "eb", miswiring, why);
}

TEST(ConformanceBodiesTest, FindsAMirroredCameraOfAHandbot) {
  expectOnHandbot(wireList<HandbotCamera>(&HandbotCamera::blobs,
                                          [](std::vector<ColorBlob>& blobs) {
                                            for (ColorBlob& blob : blobs) {
                                              blob.bearing = -blob.bearing;
                                            }
                                          }),
                  "handbot_camera (handbot_camera: bearing of the prey: 0.3");
}

template <class Ring, class Values>
Miswiring wireRing(Values Ring::*values, void (*change)(Values&)) {
  return wire<Ring>([values, change](Ring& ring) { change(ring.*values); });
}

TEST(ConformanceBodiesTest, FindsDistanceSensorsOfAHandbotThatAreWiredWrongly) {
  using Ring = HandbotDistance;
  using Values = std::array<float, Ring::kCount>;
  const std::string judged = "handbot_distance (handbot_distance: ";
  expectOnHandbot(wireRing<Ring, Values>(&Ring::distance,
                                         [](Values& ring) { std::rotate(ring.begin(), ring.begin() + 1, ring.end()); }),
                  judged);
  expectOnHandbot(
      wireRing<Ring, Values>(&Ring::distance, [](Values& ring) { std::reverse(ring.begin() + 1, ring.end()); }),
      judged);
  expectOnHandbot(wireRing<Ring, Values>(&Ring::distance,
                                         [](Values& ring) {
                                           for (float& value : ring) {
                                             value *= 100.0F;
                                           }
                                         }),
                  judged + "way from sensor 8 to the wall: 20.1");
  expectOnHandbot(wireRing<Ring, Values>(&Ring::distance,
                                         [](Values& ring) {
                                           for (float& value : ring) {
                                             value = std::min(value, 0.3F);  // many drivers do so in open space
                                           }
                                         }),
                  judged + "not true: way from sensor 7 to the wall is out of range (inf): 0.300 m");
}

TEST(ConformanceBodiesTest, FindsPalmsAndCupsThatAreWiredWrongly) {
  expectOnHandbot(wire<HandbotProximity>([](HandbotProximity& palms) { std::swap(palms.left, palms.right); }),
                  "handbot_proximity (handbot_proximity: not true: before the board the left palm feels it: 0.000");
  expectOnHandbot(wire<HandbotProximity>([](HandbotProximity& palms) { palms.left = 1.0F - palms.left; }),
                  "handbot_proximity (handbot_proximity: not true: with the arm raised the left palm feels nothing");
  expectOnHandbot(wire<HandbotVacuum>([](HandbotVacuum& cups) { std::swap(cups.left, cups.right); }),
                  "handbot_vacuum (handbot_vacuum: not true: cup 0 of the left hand is closed by the board: 0.000");
  expectOnHandbot(wire<HandbotVacuum>([](HandbotVacuum& cups) {
                    std::rotate(cups.left.begin(), cups.left.begin() + 2, cups.left.end());
                  }),
                  "handbot_vacuum (handbot_vacuum: not true: cup 0 of the left hand is closed by the board: 0.000");
  expectOnHandbot(wire<HandbotVacuum>([](HandbotVacuum& cups) {
                    for (float& cup : cups.left) {
                      cup = 1.0F - cup;
                    }
                  }),
                  "handbot_vacuum (handbot_vacuum: not true: without suction the left hand has no vacuum: 1.000");
}

TEST(ConformanceBodiesTest, FindsArmsAndHandsWhoseSpeedsAndForcesAreWrong) {
  expectOnHandbot(wire<HandbotArmsState>([](HandbotArmsState& arms) {
                    for (HandbotArmsState::Joint& joint : arms.joints) {
                      joint.speed *= -1.0;
                    }
                  }),
                  "handbot_arms (handbot_arms: way by the speeds of left_shoulder: 1.2");
  expectOnHandbot(
      wire<HandbotArmsState>([](HandbotArmsState& arms) { arms.joints[4].speed = 0.0; }),
      "handbot_arms (handbot_arms: way by the speeds of right_elbow: 0.000 rad, expected -0.800 rad +- 0.600 rad)");
  expectOnHandbot(wire<HandbotHandsState>([](HandbotHandsState& hands) { hands.right.force = 5.0; }),
                  "handbot_hands (handbot_hands: not true: the right hand, which holds nothing, feels no force");
}

TEST(ConformanceBodiesTest, FindsHeightsOfAnEyebotThatAreWrong) {
  expectOnEyebot(wire<EyebotPressure>([](EyebotPressure& pressure) { pressure.difference *= -1.0; }),
                 "eyebot_pressure (eyebot_pressure: flown up, it is higher by: -0.3");
  expectOnEyebot(wire<EyebotPressure>([](EyebotPressure& pressure) { pressure.difference *= 0.01; }),
                 "eyebot_pressure (eyebot_pressure: flown up, it is higher by: 0.00");
  expectOnEyebot(wire<EyebotAltitude>([](EyebotAltitude& altitude) { altitude.distance *= 100.0F; }),
                 "eyebot_altitude (eyebot_altitude: flown up, it is higher by: 30.");
  expectOnEyebot(wire<EyebotDistance>([](EyebotDistance& distance) { distance.up = 2.0F - distance.up; }),
                 "eyebot_distance_up (eyebot_distance_up: flown up, it is higher by: -0.3");
}

TEST(ConformanceBodiesTest, FindsAFlightToAPlaceThatIsAnotherOne) {
  std::string text = conformanceText();
  replace(text, "<eyebot_velocity/>", "<eyebot_position/>");
  EXPECT_EQ("passed", fullVerdictsOf(*start(text))["eb"]);
  const auto expectToBeFound = [&text](const Miswiring& miswiring) {
    expectFailure(text, "eb", miswiring, "eyebot_position (eyebot_position: the way along ");
  };
  expectToBeFound(wire<EyebotPosition>([](EyebotPosition& flight) { flight.position.y() *= -1.0; }));
  expectToBeFound(
      wire<EyebotPosition>([](EyebotPosition& flight) { std::swap(flight.position.x(), flight.position.y()); }));
  expectToBeFound(wire<EyebotPosition>([](EyebotPosition& flight) { flight.position *= 0.01; }));
}

/// A footbot beside a perch that charges its battery, or in a station that exchanges it.
std::string batteryWith(const std::string& parameter, const std::string& object, const std::string& rule) {
  return R"(<?xml version="1.0"?>
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>900</maxclock></framework>
  <controllers>
    <conformance id="test" library="conformance">
      <actuators><differential_drive/></actuators>
      <sensors><battery/></sensors>
      <parameters>)" +
         parameter + R"(</parameters>
    </conformance>
  </controllers>
  <arena size="5,5,1" optimization="2D">
    <footbot id="r">
      <position>2, 2, 0</position><orientation>0, 0, 0</orientation><controller>test</controller>
      <battery>true</battery><battery_capacity>5000</battery_capacity><battery_level>0.2</battery_level>
    </footbot>
    )" + object +
         R"(
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="r"/><entity id="source"/></engine></arena_physics>
  <rules>)" +
         rule + R"(</rules>
  <visualisations><verdict_monitor id="verdict" library="verdict_monitor"/></visualisations>
</ahss-config>
)";
}

const std::string charged = batteryWith(
    "<charger>true</charger>",
    "<charging_perch id=\"source\"><position>1.75, 2, 0</position><orientation>0, 0, 0</orientation></charging_perch>",
    "<charging id=\"charging\"/>");
const std::string exchanged =
    batteryWith("<exchanger>true</exchanger>",
                "<exchange_station id=\"source\"><position>1.75, 2, 0</position><orientation>0, 0, 0</orientation>"
                "<capacity>5000</capacity></exchange_station>",
                "<exchange id=\"exchange\"><swap_time>3</swap_time></exchange>");

TEST(ConformanceBodiesTest, PassesBatteriesThatAreChargedOrExchanged) {
  const auto charging = start(charged);
  EXPECT_EQ("passed", fullVerdictsOf(*charging)["r"]);
  EXPECT_EQ("battery_plausible, battery_charges, battery_drains", debugOf(*charging, "r", "passed"));
  const auto exchanging = start(exchanged);
  EXPECT_EQ("passed", fullVerdictsOf(*exchanging)["r"]);
  EXPECT_EQ("battery_exchanged, battery_plausible, battery_drains", debugOf(*exchanging, "r", "passed"));
}

TEST(ConformanceBodiesTest, FindsABatteryThatIsWiredWrongly) {
  expectFailure(charged, "r", wire<Battery>([](Battery& battery) { battery.is_charging = false; }),
                "battery_charges (battery_charges: not true: something charges it");
  expectFailure(charged, "r", wire<Battery>([](Battery& battery) { battery.power = -battery.power; }),
                "battery_charges");
  expectFailure(charged, "r", wire<Battery>([](Battery& battery) { battery.power *= 0.001F; }), "battery_charges");
  expectFailure(charged, "r", wire<Battery>([](Battery& battery) { battery.is_charging = true; }),
                "battery_drains (battery_drains: not true: the robot draws power, and nothing charges it");
  std::string used = charged;
  replace(used, "<charger>true</charger>", "");
  replace(used, "<charging id=\"charging\"/>", "");
  expectFailure(used, "r", wire<Battery>([](Battery& battery) { battery.charge = battery.capacity - battery.charge; }),
                "battery_drains (battery_drains: the charge rises while nothing charges the robot");
  expectFailure(used, "r", wire<Battery>([](Battery& battery) { battery.charge *= 100.0F; }), "battery_plausible");
  expectFailure(exchanged, "r", wire<Battery>([](Battery& battery) { battery.on_capacitor = false; }),
                "battery_exchanged (battery_exchanged: losing the old battery: not within 60.000 s");
  expectFailure(exchanged, "r", wire<Battery>([](Battery& battery) { battery.on_capacitor = true; }),
                "battery_exchanged");
  expectFailure(exchanged, "r", wire<Battery>([](Battery& battery) { battery.charge = 900.0F; }), "battery_exchanged");
}

}  // namespace
}  // namespace swarmanoid::test
