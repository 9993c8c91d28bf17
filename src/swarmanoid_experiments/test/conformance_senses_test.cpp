// The conformance test of sensors that a known world can judge: light, floor, sound, further cameras, distances. It
// passes with correct wiring, and detects and names each wrongly wired device.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "conformance_world.hpp"
#include "swarmanoid_interface/devices/color_blob_camera.hpp"
#include "swarmanoid_interface/devices/distance.hpp"
#include "swarmanoid_interface/devices/eyebot_distance.hpp"
#include "swarmanoid_interface/devices/eyebot_pan_tilt.hpp"
#include "swarmanoid_interface/devices/floor_color.hpp"
#include "swarmanoid_interface/devices/footbot_ground.hpp"
#include "swarmanoid_interface/devices/footbot_microphones.hpp"
#include "swarmanoid_interface/devices/ground.hpp"
#include "swarmanoid_interface/devices/light.hpp"

namespace swarmanoid::test {
namespace {

/// A blue floor, with a lamp on the right and a loudspeaker behind; beacon and prey are 1 m ahead and 0.5 m to the
/// left.
constexpr const char* kFootbot = R"(<?xml version="1.0"?>
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>300</maxclock></framework>
  <controllers>
    <conformance id="test" library="conformance">
      <actuators><differential_drive/></actuators>
      <sensors>
        <floor_color/><footbot_base_ground/><footbot_front_camera/><footbot_ground/><footbot_microphones/><ground/><light/>
      </sensors>
      <parameters><sound>true</sound><lamp>true</lamp><floor_color>blue</floor_color></parameters>
    </conformance>
  </controllers>
  <arena size="5,5,1" optimization="2D" floor="blue">
    <footbot id="r">
      <position>2, 2, 0</position><orientation>0, 0, 40</orientation><controller>test</controller>
    </footbot>
    <cylindric_prey id="beacon">
      <position>2.766, 2.643, 0</position><orientation>0, 0, 0</orientation>
      <radius>0.06</radius><height>0.1</height><color>yellow</color>
    </cylindric_prey>
    <cylindric_prey id="prey">
      <position>1.679, 2.383, 0</position><orientation>0, 0, 0</orientation>
      <radius>0.06</radius><height>0.1</height><color>magenta</color>
    </cylindric_prey>
    <light id="lamp"><position>2.9, 1.2, 0.3</position><orientation>0, 0, 0</orientation></light>
    <loudspeaker id="horn"><position>1.1, 3.4, 0.3</position><orientation>0, 0, 0</orientation></loudspeaker>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="r"/><entity id="beacon"/><entity id="prey"/></engine></arena_physics>
  <visualisations><verdict_monitor id="verdict" library="verdict_monitor"/></visualisations>
</ahss-config>
)";

constexpr const char* kEyebot = R"(<?xml version="1.0"?>
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>300</maxclock></framework>
  <controllers>
    <conformance id="test" library="conformance">
      <actuators><eyebot_velocity/><eyebot_pan_tilt/></actuators>
      <sensors><distances/><eyebot_distance/><eyebot_omnidirectional_camera/><eyebot_pan_tilt_camera/></sensors>
      <parameters><wall_distance>0.9</wall_distance><laser_height>1.35</laser_height></parameters>
    </conformance>
  </controllers>
  <arena size="5,5,3" optimization="3D">
    <eyebot id="r">
      <position>2, 2, 1.2</position><orientation>0, 0, 0</orientation><controller>test</controller>
    </eyebot>
    <cylindric_prey id="beacon">
      <position>2.6, 2, 0</position><orientation>0, 0, 0</orientation>
      <radius>0.06</radius><height>0.1</height><color>yellow</color>
    </cylindric_prey>
    <block id="wall">
      <position>2, 1.05, 1.5</position><orientation>0, 0, 0</orientation><size>2, 0.1, 1</size>
    </block>
    <cylindric_prey id="prey">
      <position>2, 2.6, 0</position><orientation>0, 0, 0</orientation>
      <radius>0.06</radius><height>0.1</height><color>magenta</color>
    </cylindric_prey>
  </arena>
  <engines><dynamics3d id="space"/></engines>
  <arena_physics><engine id="space"><entity id="r"/></engine></arena_physics>
  <visualisations><verdict_monitor id="verdict" library="verdict_monitor"/></visualisations>
</ahss-config>
)";

void expectFailure(const char* text, const Miswiring& miswiring, const std::string& why) {
  expectFailure(text, "r", miswiring, why);
}

TEST(ConformanceSensesTest, PassesAFootbot) {
  const auto simulation = start(kFootbot);
  EXPECT_EQ("passed", fullVerdictsOf(*simulation)["r"]);
  EXPECT_EQ(
      "footbot_front_camera, footbot_front_camera_turns, floor_color, footbot_base_ground, footbot_ground, "
      "footbot_microphones_hear, "
      "footbot_microphones_turn, ground, light, light_turns",
      debugOf(*simulation, "r", "passed"));
}

TEST(ConformanceSensesTest, WhatTheWorldDoesNotHaveIsNamed) {
  const auto simulation =
      start(kFootbot, {{"controllers.test.parameters.sound", "false"}, {"controllers.test.parameters.lamp", "false"}});
  EXPECT_EQ("passed", fullVerdictsOf(*simulation)["r"]);
  EXPECT_EQ("footbot_microphones, light", debugOf(*simulation, "r", "unchecked_devices"));
}

TEST(ConformanceSensesTest, FindsLightSensorsThatAreDeadOrGoRoundTheOtherWay) {
  const auto rewire = [](auto change) {
    return wire<Light>([change, kept = std::make_shared<std::vector<LightReading>>()](Light& light) {
      kept->assign(light.sensors.begin(), light.sensors.end());
      change(*kept);
      light.sensors = Span<const LightReading>(kept->data(), kept->size());
    });
  };
  expectFailure(kFootbot, rewire([](std::vector<LightReading>& sensors) {
                  for (LightReading& reading : sensors) {
                    reading.value = 0.0F;
                  }
                }),
                "light (light: not true: some sensor feels the lamp");
  expectFailure(kFootbot, rewire([](std::vector<LightReading>& sensors) {
                  for (std::size_t i = 0; i < sensors.size() / 2; ++i) {
                    std::swap(sensors[i].value, sensors[sensors.size() - 1 - i].value);
                  }
                }),
                "light_turns (light_turns: bearing of the light after a turn to the left: ");
}

TEST(ConformanceSensesTest, FindsSpotsThatReadAnotherFloor) {
  expectFailure(kFootbot, wire<FootbotGround>([](FootbotGround& ground) {
                  for (float& value : ground.value) {
                    value = 1.0F - value;
                  }
                }),
                "footbot_ground (footbot_ground: spot 0 reads: 0.667, expected 0.333 +- 0.150");
  expectFailure(kFootbot, wire<FootbotBaseGround>([](FootbotBaseGround& ground) { ground.value[2] = 0.0F; }),
                "footbot_base_ground (footbot_base_ground: spot 2 reads: 0.000, expected 0.333 +- 0.150)");
  expectFailure(kFootbot, wire<FloorColor>([](FloorColor& floor) { std::swap(floor.color.red, floor.color.blue); }),
                "floor_color (floor_color: not true: the floor is about blue; found red)");
  expectFailure(kFootbot, wire<Ground>([kept = std::make_shared<std::vector<GroundSpot>>()](Ground& ground) {
                  kept->assign(ground.sensors.begin(), ground.sensors.end());
                  kept->back().value = 0.9F;
                  ground.sensors = Span<const GroundSpot>(kept->data(), kept->size());
                }),
                "ground (ground: spot ");
}

TEST(ConformanceSensesTest, FindsMicrophonesFromTheOtherSide) {
  expectFailure(kFootbot, wire<FootbotMicrophones>([](FootbotMicrophones& heard) {
                  std::swap(heard.level[1], heard.level[3]);
                  std::swap(heard.level[0], heard.level[2]);
                }),
                "footbot_microphones_hear (footbot_microphones_hear: not true: levels rise towards its bearing, ");
}

/// @param turn of all blobs in the picture [rad]
template <class Camera>
Miswiring turned(float turn, float sign) {
  return wire<Camera>([turn, sign, kept = std::make_shared<std::vector<ColorBlob>>()](Camera& camera) {
    kept->assign(camera.blobs.begin(), camera.blobs.end());
    for (ColorBlob& blob : *kept) {
      blob.bearing = sign * blob.bearing + turn;
    }
    camera.blobs = Span<const ColorBlob>(kept->data(), kept->size());
  });
}

TEST(ConformanceSensesTest, FindsACameraThatIsMountedAskewOrMirrored) {
  expectFailure(
      kFootbot, turned<FootbotFrontCamera>(0.0F, -1.0F),
      "footbot_front_camera_turns (footbot_front_camera_turns: bearing of the beacon after a turn to the left: ");
  expectFailure(kFootbot, turned<FootbotFrontCamera>(0.4F, 1.0F),
                "footbot_front_camera (footbot_front_camera: bearing of the beacon ahead: 0.4");
  expectFailure(kEyebot, turned<EyebotOmnidirectionalCamera>(0.0F, -1.0F),
                "eyebot_omnidirectional_camera (eyebot_omnidirectional_camera: bearing of the prey: -1.57");
}

TEST(ConformanceSensesTest, PassesAnEyebotAndFindsASensorThatLooksUpInsteadOfDown) {
  const auto simulation = start(kEyebot);
  EXPECT_EQ("passed", fullVerdictsOf(*simulation)["r"]);
  EXPECT_EQ("distances, eyebot_distance_around, eyebot_omnidirectional_camera, eyebot_distance, eyebot_pan_tilt",
            debugOf(*simulation, "r", "passed"));
  expectFailure(kEyebot, wire<EyebotDistance>([](EyebotDistance& distance) { std::swap(distance.up, distance.down); }),
                "eyebot_distance (eyebot_distance: flown down, it is higher by: ");
}

TEST(ConformanceSensesTest, FindsDistanceSensorsAroundAnEyebotThatAreCountedFromElsewhere) {
  const std::string judged = "eyebot_distance_around (eyebot_distance_around: ";
  expectFailure(kEyebot, wire<EyebotDistance>([](EyebotDistance& distance) {
                  std::rotate(distance.around.begin(), distance.around.begin() + 1, distance.around.end());
                }),
                judged);
  expectFailure(kEyebot, wire<EyebotDistance>([](EyebotDistance& distance) {
                  std::reverse(distance.around.begin() + 1, distance.around.end());
                }),
                judged);
}

TEST(ConformanceSensesTest, FindsAMountingThatPansTheOtherWayOrTiltsUpwards) {
  const std::string failure = "eyebot_pan_tilt (eyebot_pan_tilt: not true: turned towards the prey, the camera sees it";
  expectFailure(kEyebot, wire<EyebotPanTilt>([](EyebotPanTilt& mounting) { mounting.pan = -mounting.pan; }), failure);
  expectFailure(kEyebot, wire<EyebotPanTilt>([](EyebotPanTilt& mounting) { mounting.tilt = -mounting.tilt; }), failure);
}

TEST(ConformanceSensesTest, FindsDistanceSensorsThatLookToTheOtherSide) {
  expectFailure(kEyebot, wire<Distance>([kept = std::make_shared<std::vector<DistanceReading>>()](Distance& ring) {
                  kept->assign(ring.sensors.begin(), ring.sensors.end());
                  for (DistanceReading& reading : *kept) {
                    reading.angle = -reading.angle;
                  }
                  ring.sensors = Span<const DistanceReading>(kept->data(), kept->size());
                }),
                "distances (distances: way from sensor ");
}

}  // namespace
}  // namespace swarmanoid::test
