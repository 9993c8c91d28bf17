// The conformance test of joints, holders, wheels and the antenna for radio tags: it passes with correct wiring, and
// detects and names each wrongly wired device.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "conformance_world.hpp"
#include "swarmanoid_interface/devices/holders.hpp"
#include "swarmanoid_interface/devices/imu.hpp"
#include "swarmanoid_interface/devices/joints.hpp"
#include "swarmanoid_interface/devices/odometry.hpp"
#include "swarmanoid_interface/devices/rfid.hpp"
#include "swarmanoid_interface/devices/wheel_encoders.hpp"
#include "swarmanoid_interface/devices/wheels.hpp"

namespace swarmanoid::test {
namespace {

/// A handbot with the devices of any robot: its left hand reaches a board, and there is a ceiling for its rope.
constexpr const char* kHandbot = R"(<?xml version="1.0"?>
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>600</maxclock></framework>
  <controllers>
    <conformance id="test" library="conformance">
      <actuators><joints/><holders/></actuators>
      <sensors><joint_states/><holder_states/></sensors>
      <parameters><held>0, 2</held></parameters>
    </conformance>
  </controllers>
  <arena size="5,5,3" optimization="3D">
    <handbot id="r">
      <position>2, 2, 0</position><orientation>0, 0, 0</orientation><controller>test</controller>
    </handbot>
    <block id="board">
      <position>2.263, 2.11, 0.15</position><orientation>0, 0, 0</orientation><size>0.12, 0.1, 0.3</size>
    </block>
    <block id="ceiling">
      <position>2, 2, 2.55</position><orientation>0, 0, 0</orientation><size>3, 3, 0.1</size>
      <ferromagnetic>true</ferromagnetic>
    </block>
  </arena>
  <engines><dynamics3d id="space"/></engines>
  <arena_physics>
    <engine id="space"><entity id="r"/><entity id="board"/><entity id="ceiling"/></engine>
  </arena_physics>
  <visualisations><verdict_monitor id="verdict" library="verdict_monitor"/></visualisations>
</ahss-config>
)";

/// A footbot over a tag, with another tag beside it; it is driven by its wheels, or by speed and turn rate.
std::string footbotWith(const std::string& drive, const std::string& sensor) {
  return R"(<?xml version="1.0"?>
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>600</maxclock></framework>
  <controllers>
    <conformance id="test" library="conformance">
      <actuators><rfid_writer/>)" +
         drive + "</actuators><sensors><rfid_reader/>" + sensor + R"(</sensors>
      <parameters><tag_id>7</tag_id><tag_data>1234</tag_data></parameters>
    </conformance>
  </controllers>
  <arena size="5,5,1" optimization="2D">
    <footbot id="r">
      <position>2, 2, 0</position><orientation>0, 0, 40</orientation><controller>test</controller>
    </footbot>
    <rfid_tag id="beside">
      <position>2.03, 2, 0</position><orientation>0, 0, 0</orientation><tag>20</tag><tag_data>5</tag_data>
    </rfid_tag>
    <rfid_tag id="below">
      <position>2, 2, 0</position><orientation>0, 0, 0</orientation><tag>7</tag><tag_data>1234</tag_data>
    </rfid_tag>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="r"/></engine></arena_physics>
  <visualisations><verdict_monitor id="verdict" library="verdict_monitor"/></visualisations>
</ahss-config>
)";
}

const std::string tag_reader = footbotWith("<differential_drive/>", "");
const std::string arc_driver = footbotWith("<differential_drive/>", "<odometry/><wheel_encoders/><imu/>");
const std::string wheel_turner = footbotWith("<wheels/>", "<wheel_encoders/>");

template <class Change>
Miswiring wireStates(Change change) {
  return wireList<JointStates>(&JointStates::joints, change);
}
template <class Change>
Miswiring wireHeld(Change change) {
  return wireList<HolderStates>(&HolderStates::holders, change);
}
template <class Change>
Miswiring wireTags(Change change) {
  return wireList<RfidReader>(&RfidReader::tags, change);
}

using JointList = std::vector<JointStates::Joint>;
using HolderList = std::vector<HolderStates::Holder>;
using TagList = std::vector<RfidTagReading>;

TEST(ConformancePartsTest, PassesWhatIsWiredRightly) {
  const auto handbot = start(kHandbot);
  EXPECT_EQ("passed", fullVerdictsOf(*handbot)["r"]);
  EXPECT_EQ("joints, holders", debugOf(*handbot, "r", "passed"));
  const auto reader = start(tag_reader);
  EXPECT_EQ("passed", fullVerdictsOf(*reader)["r"]);
  EXPECT_EQ("rfid_reader, rfid_reader_leaves, rfid_writer", debugOf(*reader, "r", "passed"));
  const auto turner = start(wheel_turner);
  EXPECT_EQ("passed", fullVerdictsOf(*turner)["r"]);
  EXPECT_EQ("rfid_reader, rfid_writer, wheels", debugOf(*turner, "r", "passed"));
}

TEST(ConformancePartsTest, FindsJointsThatAreWiredWrongly) {
  expectFailure(kHandbot, "r", wireStates([](JointList& joints) { std::swap(joints[1], joints[2]); }),
                "joints (joints: angle of joint 1: ");
  expectFailure(kHandbot, "r", wire<Joints>([](Joints& joints) { joints.joints[3].angle *= -1.0; }),
                "joints (joints: angle of joint 3: ");
  expectFailure(kHandbot, "r", wireStates([](JointList& joints) { joints[0].angle *= kDegrees; }),
                "joints (joints: angle of joint 0: ");
  expectFailure(kHandbot, "r", wireStates([](JointList& joints) { joints[4].speed *= -1.0; }),
                "joints (joints: speed of joint 4: ");
  expectFailure(kHandbot, "r", wire<Joints>([](Joints& joints) { joints.joints[5].speed *= 2.0; }),
                "joints (joints: speed of joint 5: ");
}

TEST(ConformancePartsTest, FindsHoldersThatAreWiredWrongly) {
  expectFailure(kHandbot, "r", wireHeld([](HolderList& holders) { std::swap(holders[0], holders[1]); }),
                "holders (holders: taking hold with holder 0: not within 10.000 s");
  expectFailure(kHandbot, "r",
                wire<Holders>([](Holders& holders) { std::swap(holders.holders[0], holders.holders[1]); }),
                "holders (holders: taking hold with holder 0: not within 10.000 s");
  expectFailure(kHandbot, "r", wireHeld([](HolderList& holders) { holders[1].is_holding = true; }),
                "holders (holders: not true: commanded holder 0, holder 1 does not hold");
  expectFailure(kHandbot, "r", wire<Holders>([](Holders& holders) { holders.holders[2].winding_speed *= -1.0; }),
                "holders (holders: wound in, the rope is shorter by: -0.1");
  expectFailure(kHandbot, "r", wireHeld([](HolderList& holders) { holders[2].length *= 100.0; }),
                "holders (holders: wound in, the rope is shorter by: 10.");
  expectFailure(kHandbot, "r", wireHeld([](HolderList& holders) { holders[2].force = 0.0; }),
                "holders (holders: not true: it pulls: 0.000 N");
}

TEST(ConformancePartsTest, FindsAReaderOfTagsThatIsWiredWrongly) {
  expectFailure(tag_reader, "r", wireTags([](TagList& tags) { std::reverse(tags.begin(), tags.end()); }),
                "rfid_reader (rfid_reader: not true: the tag is 7; found 20");
  expectFailure(tag_reader, "r", wireTags([](TagList& tags) {
                  for (RfidTagReading& tag : tags) {
                    std::swap(tag.id, tag.data);
                  }
                }),
                "rfid_reader (rfid_reader: not true: the tag is 7; found 1234");
  expectFailure(
      tag_reader, "r", wireTags([first = std::make_shared<TagList>()](TagList& tags) {
        if (first->empty()) {
          *first = tags;
        }
        tags = *first;
      }),
      "rfid_reader_leaves, rfid_writer (rfid_reader_leaves: not true: driven away from the tag, none answers");
}

TEST(ConformancePartsTest, FindsAWriterOfTagsThatIsWiredWrongly) {
  expectFailure(tag_reader, "r", wire<RfidWriter>([](RfidWriter& writer) { writer.writes = false; }),
                "rfid_writer (rfid_writer: not true: it holds ");
  expectFailure(tag_reader, "r",
                wire<RfidWriter>([](RfidWriter& writer) { writer.data = __builtin_bswap32(writer.data); }),
                "rfid_writer (rfid_writer: not true: it holds ");
  expectFailure(tag_reader, "r", wire<RfidWriter>([](RfidWriter& writer) { writer.id = 0; }),
                "rfid_writer (rfid_writer: not true: it holds 16910294; found 1234");
}

TEST(ConformancePartsTest, FindsWheelsThatAreWiredWrongly) {
  expectFailure(wheel_turner, "r", wire<Wheels>([](Wheels& wheels) { std::swap(wheels.left, wheels.right); }),
                "wheels (wheels: the left wheel has turned by: 3.");
  expectFailure(wheel_turner, "r", wire<WheelEncoders>([](WheelEncoders& encoders) { encoders.right.turned *= -1.0; }),
                "wheels (wheels: the right wheel has turned by: -3.");
  expectFailure(wheel_turner, "r",
                wire<WheelEncoders>([](WheelEncoders& encoders) { encoders.left.turned *= kDegrees; }),
                "wheels (wheels: the left wheel has turned by: ");
}

void expectOnAnArc(const Miswiring& miswiring, const std::string& why) {
  expectFailure(arc_driver, "r", miswiring, why);
}

TEST(ConformancePartsTest, FindsWhatAnswersAnArcWrongly) {
  EXPECT_EQ("passed", fullVerdictsOf(*start(arc_driver))["r"]);
  const std::string by_odometry = "odometry (odometry: ";
  expectOnAnArc(wire<Odometry>([](Odometry& odometry) { odometry.y *= -1.0; }), by_odometry + "way to the left");
  expectOnAnArc(wire<Odometry>([](Odometry& odometry) { odometry.heading *= kDegrees; }), by_odometry);
  expectOnAnArc(wire<Odometry>([](Odometry& odometry) { odometry.speed *= 3.6; }), by_odometry + "way by the speeds");
  expectOnAnArc(wire<Odometry>([](Odometry& odometry) { odometry.turn_rate *= -1.0; }),
                by_odometry + "turned by the turn rates");
  const std::string by_encoders = "wheel_encoders (wheel_encoders: ";
  expectOnAnArc(wire<WheelEncoders>([](WheelEncoders& encoders) { std::swap(encoders.left, encoders.right); }),
                by_encoders + "not true: the outer wheel has turned further");
  expectOnAnArc(wire<WheelEncoders>([](WheelEncoders& encoders) { encoders.left.speed *= kDegrees; }),
                by_encoders + "the left wheel has turned by");
  expectOnAnArc(wire<WheelEncoders>([](WheelEncoders& encoders) { encoders.right.step *= -1.0; }),
                by_encoders + "not true: the last step of the right wheel goes the way");
  expectOnAnArc(wire<Imu>([](Imu& imu) { imu.angular_velocity.z() *= -1.0; }), "imu_turns (imu_turns: turn rate");
  expectOnAnArc(wire<Imu>([](Imu& imu) { imu.linear_acceleration *= -1.0; }), "imu_at_rest (imu_at_rest: acceleration");
}

}  // namespace
}  // namespace swarmanoid::test
