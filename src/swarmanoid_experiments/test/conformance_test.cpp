// The conformance test passes in every engine that simulates the devices; a wrongly wired device fails it, and is
// named.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "conformance_world.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/eyebot_laser.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"
#include "swarmanoid_interface/devices/eyebot_velocity.hpp"
#include "swarmanoid_interface/devices/footbot_gripper.hpp"
#include "swarmanoid_interface/devices/footbot_proximity.hpp"
#include "swarmanoid_interface/devices/footbot_turret.hpp"
#include "swarmanoid_interface/devices/footbot_wheels.hpp"
#include "swarmanoid_interface/devices/handbot_arms.hpp"
#include "swarmanoid_interface/devices/handbot_hands.hpp"
#include "swarmanoid_interface/devices/handbot_rope.hpp"
#include "swarmanoid_interface/devices/leds.hpp"

namespace swarmanoid::test {
namespace {

using Verdicts = std::map<std::string, std::string>;
const Verdicts all_passed = {{"fb", "passed"},          {"fb_observer", "passed"}, {"eb", "passed"},
                             {"eb_observer", "passed"}, {"hb", "passed"},          {"hb_observer", "passed"}};

Verdicts verdictsOf(Simulation& simulation) {
  Verdicts verdicts = fullVerdictsOf(simulation);
  for (auto& [robot, verdict] : verdicts) {
    verdict = verdict.substr(0, verdict.find(" ("));  // the details are in brackets
  }
  return verdicts;
}

class ConformanceTest : public testing::TestWithParam<std::string> {};

TEST_P(ConformanceTest, PassesInThisEngine) {
  std::string text = conformanceText();
  replace(text, "<dynamics2d id=\"ground\"/>", "<" + GetParam() + " id=\"ground\"/>");
  const auto simulation = start(text);
  EXPECT_EQ(all_passed, verdictsOf(*simulation));
  EXPECT_EQ(true, simulation->success());
  EXPECT_TRUE(simulation->failures().empty());
  EXPECT_EQ(
      "footbot_leds (an observer judges), loudspeaker (an observer judges), bluetooth, range_and_bearing, rfid_reader, "
      "rfid_writer, wifi, footbot_camera, wheels_ahead, wheels_left, range_and_bearing_turns, rfid_reader_leaves, "
      "footbot_proximity, gripper_closes, footbot_turret, gripper_opens",
      debugOf(*simulation, "fb", "passed"));
  EXPECT_EQ("footbot_leds, loudspeaker", debugOf(*simulation, "fb", "unchecked_devices"));
  EXPECT_EQ(
      "eyebot_leds (an observer judges), range_and_bearing, eyebot_altitude, eyebot_camera, eyebot_distance, "
      "eyebot_distance_up, eyebot_pressure, velocity_in_the_plane, yaw_left, range_and_bearing_turns, eyebot_laser, "
      "velocity_up, eyebot_magnet",
      debugOf(*simulation, "eb", "passed"));
  EXPECT_EQ(
      "handbot_leds (an observer judges), handbot_camera, handbot_distance, range_and_bearing, handbot_arms, "
      "handbot_hands, handbot_proximity, handbot_vacuum, handbot_rope",
      debugOf(*simulation, "hb", "passed"));
  EXPECT_EQ("handbot_leds", debugOf(*simulation, "hb", "unchecked_devices"));
  EXPECT_EQ(
      "leds_of_the_other, bluetooth_of_the_other, loudspeaker_of_the_other, range_and_bearing_of_the_other, "
      "wifi_of_the_other",
      debugOf(*simulation, "fb_observer", "passed"));
}

INSTANTIATE_TEST_SUITE_P(Engines, ConformanceTest, testing::Values("kinematics2d", "dynamics2d", "dynamics3d"),
                         [](const auto& engine) { return engine.param; });

class PlanarEyebotTest : public testing::TestWithParam<std::string> {};

/// In a plane an eyebot has no magnet, and does not move up: the test reports these as unchecked.
TEST_P(PlanarEyebotTest, PassesAndNamesWhatIsUnchecked) {
  std::string text = conformanceText();
  replace(text, "<eyebot_magnet/>", "");
  replace(text, "<ceiling>true</ceiling>", "<upwards>false</upwards>");
  replace(text, "<entity id=\"eb\"/>", "");
  replace(text, "<dynamics3d id=\"space\"/>",
          "<dynamics3d id=\"space\"/><" + GetParam() + " id=\"sky\"><distance>1.2</distance></" + GetParam() + ">");
  replace(text, "<arena_physics>", "<arena_physics><engine id=\"sky\"><entity id=\"eb\"/></engine>");
  const auto simulation = start(text);
  EXPECT_EQ(all_passed, verdictsOf(*simulation));
  EXPECT_EQ(
      "eyebot_altitude (the robot cannot move up and down here (upwards is false)); eyebot_distance (the robot cannot "
      "move up and down here (upwards is false)); eyebot_position (not listed: eyebot_position); eyebot_pressure (the "
      "robot cannot move up and down here (upwards is false)); velocity_up (the robot cannot move up and down here "
      "(upwards is false)); "
      "eyebot_magnet (not listed: eyebot_magnet)",
      debugOf(*simulation, "eb", "unchecked"));
  EXPECT_EQ("eyebot_altitude, eyebot_distance, eyebot_leds, eyebot_magnet_state, eyebot_pressure",
            debugOf(*simulation, "eb", "unchecked_devices"));
}

INSTANTIATE_TEST_SUITE_P(Engines, PlanarEyebotTest, testing::Values("kinematics2d", "dynamics2d"),
                         [](const auto& engine) { return engine.param; });

TEST(ConformanceParametersTest, WhatIsNotThereIsNamedAndWhatIsWronglyPlacedFails) {
  std::string text = conformanceText();
  const std::string parameters = "<partner>fb_observer</partner>";
  replace(text, parameters, parameters + "<wall_distance>0</wall_distance><prey_distance>0</prey_distance>");
  const auto simulation = start(text);
  EXPECT_EQ(all_passed, verdictsOf(*simulation));
  EXPECT_EQ(
      "footbot_proximity (there is no wall (wall_distance is 0)); gripper_closes (there is no prey (prey_distance is "
      "0)); gripper_opens (there is no prey (prey_distance is 0))",
      debugOf(*simulation, "fb", "unchecked"));
  EXPECT_EQ("footbot_gripper, footbot_gripper_state, footbot_leds, footbot_proximity, loudspeaker",
            debugOf(*simulation, "fb", "unchecked_devices"));

  text = conformanceText();
  replace(text, parameters, parameters + "<prey_bearing>-90</prey_bearing>");
  const auto wrong = start(text);
  EXPECT_EQ("conformance test failed: footbot_camera", verdictsOf(*wrong)["fb"]);
  ASSERT_EQ(1U, wrong->failures().size());
  EXPECT_EQ(
      "conformance test failed: footbot_camera (footbot_camera: bearing of the prey: 1.571 rad, expected -1.571 rad +- "
      "0.150 rad)",
      wrong->failures()[0].reason);
  EXPECT_EQ(false, wrong->success());
}

TEST(ConformanceParametersTest, ATestThatCouldCheckNothingHasNotPassed) {
  std::string text = conformanceText();
  for (const char* device : {"footbot_wheels", "footbot_gripper", "footbot_turret", "range_and_bearing", "wifi",
                             "bluetooth", "rfid_writer", "footbot_camera", "rfid_reader"}) {
    replace(text, "<" + std::string(device) + "/>", "");
  }
  const auto simulation = start(text);
  EXPECT_EQ("conformance test failed: nothing could be checked", verdictsOf(*simulation)["fb"]);
  EXPECT_EQ(
      "footbot_camera (not listed: footbot_camera); wheels_ahead (not listed: footbot_wheels, footbot_camera); "
      "wheels_left (not listed: footbot_wheels, footbot_camera); footbot_proximity (not listed: footbot_wheels, "
      "footbot_camera); gripper_closes (not listed: footbot_gripper, footbot_wheels, footbot_camera); footbot_turret "
      "(not listed: footbot_turret); gripper_opens (not listed: footbot_gripper, footbot_wheels, footbot_camera)",
      debugOf(*simulation, "fb", "unchecked"));
  EXPECT_EQ(
      "bluetooth_received, footbot_gripper_state, footbot_leds, footbot_proximity, footbot_turret_state, "
      "loudspeaker, range_and_bearing_received, wifi_received",
      debugOf(*simulation, "fb", "unchecked_devices"));
}

/// A device with a wrong driver, and the robots and checks that detect it.
struct Mistake {
  const char* name;
  const char* robot;
  Miswiring miswiring;
  Verdicts wrong;  ///< verdicts of the robots that do not pass
};

std::ostream& operator<<(std::ostream& out, const Mistake& mistake) { return out << mistake.name; }

class MistakeTest : public testing::TestWithParam<Mistake> {};

TEST_P(MistakeTest, IsFoundAndNamed) {
  const Mistake& mistake = GetParam();
  const auto simulation =
      start(conformanceText(), {{"arena." + std::string(mistake.robot) + ".controller.source", "remote"}});
  MiswiredRobot robot(*simulation, mistake.robot, mistake.miswiring);
  Verdicts expected = all_passed;
  for (const auto& [name, verdict] : mistake.wrong) {
    expected[name] = verdict;
  }
  EXPECT_EQ(expected, verdictsOf(*simulation));
}

/// @param change function that changes each blob
template <class Camera, class Change>
Miswiring wireCamera(Change change) {
  return wireList<Camera>(&Camera::blobs, [change](std::vector<ColorBlob>& blobs) {
    for (ColorBlob& blob : blobs) {
      change(blob);
    }
  });
}

const Mistake mistakes[] = {
    {"NoMistake", "fb", wire<FootbotWheels>([](FootbotWheels&) {}), {}},
    {"WheelsSwapped",
     "fb",
     wire<FootbotWheels>([](FootbotWheels& wheels) { std::swap(wheels.left, wheels.right); }),
     {{"fb", "conformance test failed: wheels_left"}}},
    {"WheelsBackwards",
     "fb",
     wire<FootbotWheels>([](FootbotWheels& wheels) { wheels.setAngularVelocity(-wheels.left, -wheels.right); }),
     {{"fb", "conformance test failed: wheels_ahead, wheels_left"}}},
    {"WheelsInMetresASecond",
     "fb",
     wire<FootbotWheels>([](FootbotWheels& wheels) {
       wheels.setAngularVelocity(wheels.left * FootbotWheels::kRadius, wheels.right * FootbotWheels::kRadius);
     }),
     {{"fb", "conformance test failed: wheels_ahead, wheels_left"}}},
    {"ProximityClockwise",
     "fb",
     wire<FootbotProximity>([](FootbotProximity& ring) { std::reverse(ring.value.begin() + 1, ring.value.end()); }),
     {{"fb", "conformance test failed: footbot_proximity"}}},
    {"ProximityFromBehind",
     "fb",
     wire<FootbotProximity>(
         [](FootbotProximity& ring) { std::rotate(ring.value.begin(), ring.value.begin() + 12, ring.value.end()); }),
     {{"fb", "conformance test failed: footbot_proximity"}}},
    {"ProximityAlwaysHigh",
     "fb",
     wire<FootbotProximity>([](FootbotProximity& ring) { ring.value[0] = 1.0F; }),
     {{"fb", "conformance test failed: footbot_proximity"}}},
    {"CameraClockwise",
     "fb",
     wireCamera<FootbotCamera>([](ColorBlob& blob) { blob.bearing = -blob.bearing; }),
     {{"fb", "conformance test failed: footbot_camera"}}},
    {"CameraInDegrees",
     "fb",
     wireCamera<FootbotCamera>([](ColorBlob& blob) { blob.bearing *= static_cast<float>(kDegrees); }),
     {{"fb", "conformance test failed: footbot_camera"}}},
    {"CameraInCentimetres",
     "fb",
     wireCamera<FootbotCamera>([](ColorBlob& blob) { blob.distance *= 100.0F; }),
     {{"fb", "conformance test failed: footbot_camera"}}},
    {"CameraUpsideDown",
     "fb",
     wireCamera<FootbotCamera>([](ColorBlob& blob) { blob.elevation = -blob.elevation; }),
     {{"fb", "conformance test failed: footbot_camera"}}},
    {"ElevationInDegrees",
     "eb",
     wireCamera<EyebotCamera>([](ColorBlob& blob) { blob.elevation *= static_cast<float>(kDegrees); }),
     {{"eb", "conformance test failed: eyebot_camera"}}},
    {"LedsClockwise",
     "fb",
     wire<FootbotLeds>([](FootbotLeds& leds) { std::reverse(leds.ring.begin() + 1, leds.ring.end()); }),
     {{"fb_observer", "conformance test failed: leds_of_the_other"}}},
    {"LedsFromTheLeft",
     "fb",
     wire<FootbotLeds>(
         [](FootbotLeds& leds) { std::rotate(leds.ring.begin(), leds.ring.begin() + 9, leds.ring.end()); }),
     {{"fb_observer", "conformance test failed: leds_of_the_other"}}},
    {"GripperOpenForClosed",
     "fb",
     wire<FootbotGripper>([](FootbotGripper& gripper) { gripper.closed = !gripper.closed; }),
     {{"fb", "conformance test failed: gripper_closes"}}},
    {"GripperStateUpsideDown",
     "fb",
     wire<FootbotGripperState>([](FootbotGripperState& state) { state.gripping = !state.gripping; }),
     {{"fb", "conformance test failed: gripper_closes, footbot_turret"}}},
    {"GripperNeverOpens",
     "fb",
     wire<FootbotGripper>([was = false](FootbotGripper& gripper) mutable {
       was = was || gripper.closed;
       gripper.closed = was;
     }),
     {{"fb", "conformance test failed: gripper_opens"}}},
    {"TurretClockwise",
     "fb",
     wire<FootbotTurret>([](FootbotTurret& turret) { turret.angle = -turret.angle; }),
     {{"fb", "conformance test failed: footbot_turret"}}},
    {"TurretStateInDegrees",
     "fb",
     wire<FootbotTurretState>([](FootbotTurretState& state) { state.angle *= kDegrees; }),
     {{"fb", "conformance test failed: footbot_turret"}}},
    {"EyebotCameraClockwise",
     "eb",
     wireCamera<EyebotCamera>([](ColorBlob& blob) { blob.bearing = -blob.bearing; }),
     {{"eb", "conformance test failed: eyebot_camera"}}},
    {"VelocityAheadIsLeft",
     "eb",
     wire<EyebotVelocity>([](EyebotVelocity& velocity) { std::swap(velocity.linear.x(), velocity.linear.y()); }),
     {{"eb", "conformance test failed: velocity_in_the_plane"}}},
    {"VelocityRightForLeft",
     "eb",
     wire<EyebotVelocity>([](EyebotVelocity& velocity) { velocity.linear.y() *= -1.0; }),
     {{"eb", "conformance test failed: velocity_in_the_plane"}}},
    {"YawClockwise",
     "eb",
     wire<EyebotVelocity>([](EyebotVelocity& velocity) { velocity.yaw_rate *= -1.0; }),
     {{"eb", "conformance test failed: yaw_left"}}},
    {"DownForUp",
     "eb",
     wire<EyebotVelocity>([](EyebotVelocity& velocity) { velocity.linear.z() *= -1.0; }),
     {{"eb",
       "conformance test failed: eyebot_altitude, eyebot_distance, eyebot_distance_up, eyebot_pressure, velocity_up, "
       "eyebot_magnet"}}},
    {"LaserClockwise",
     "eb",
     wire<EyebotLaser>([](EyebotLaser& laser) { laser.pan = -laser.pan; }),
     {{"eb", "conformance test failed: eyebot_laser"}}},
    {"LaserTiltInDegrees",
     "eb",
     wire<EyebotLaser>([](EyebotLaser& laser) { laser.tilt /= kDegrees; }),
     {{"eb", "conformance test failed: eyebot_laser"}}},
    {"EyebotLedsClockwise",
     "eb",
     wire<EyebotLeds>([](EyebotLeds& leds) { std::reverse(leds.ring.begin() + 1, leds.ring.end()); }),
     {{"eb_observer", "conformance test failed: leds_of_the_other"}}},
    {"MagnetOffForOn",
     "eb",
     wire<EyebotMagnet>([](EyebotMagnet& magnet) { magnet.on = !magnet.on; }),
     {{"eb", "conformance test failed: eyebot_magnet"}}},
    {"ArmsSwapped",
     "hb",
     wire<HandbotArms>([](HandbotArms& arms) { std::swap(arms.left, arms.right); }),
     {{"hb", "conformance test failed: handbot_arms"}}},
    {"ElbowsMirrored",
     "hb",
     wire<HandbotArms>(
         [](HandbotArms& arms) {
           arms.left.elbow *= -1.0;
           arms.right.elbow *= -1.0;
         }),
     {{"hb", "conformance test failed: handbot_arms"}}},
    {"HandsSwapped",
     "hb",
     wire<HandbotHands>([](HandbotHands& hands) { std::swap(hands.left, hands.right); }),
     {{"hb", "conformance test failed: handbot_hands"}}},
    {"HandStatesSwapped",
     "hb",
     wire<HandbotHandsState>([](HandbotHandsState& hands) { std::swap(hands.left, hands.right); }),
     {{"hb", "conformance test failed: handbot_hands"}}},
    {"RopeWoundOutForIn",
     "hb",
     wire<HandbotRope>([](HandbotRope& rope) { rope.winding_speed *= -1.0; }),
     {{"hb", "conformance test failed: handbot_rope"}}}};

INSTANTIATE_TEST_SUITE_P(Devices, MistakeTest, testing::ValuesIn(mistakes),
                         [](const auto& mistake) { return mistake.param.name; });

}  // namespace
}  // namespace swarmanoid::test
