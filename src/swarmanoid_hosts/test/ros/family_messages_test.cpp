// Converts devices of any robot to messages and back.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "message_bench.hpp"
#include "swarmanoid_hosts/ros/devices/battery.hpp"
#include "swarmanoid_hosts/ros/devices/floor_color.hpp"
#include "swarmanoid_hosts/ros/devices/ground.hpp"
#include "swarmanoid_hosts/ros/devices/holders.hpp"
#include "swarmanoid_hosts/ros/devices/joints.hpp"
#include "swarmanoid_hosts/ros/devices/led_array.hpp"
#include "swarmanoid_hosts/ros/devices/leds.hpp"
#include "swarmanoid_hosts/ros/devices/light.hpp"
#include "swarmanoid_hosts/ros/devices/loudspeaker.hpp"
#include "swarmanoid_hosts/ros/devices/microphones.hpp"
#include "swarmanoid_hosts/ros/devices/proximity.hpp"
#include "swarmanoid_hosts/ros/devices/rfid.hpp"

namespace swarmanoid {
namespace {

using test::bytesOf;
using test::expectNothingLost;
using test::refusalOf;

TEST(FamilyMessages, KeepProximityOfAnyRobot) {
  const std::array<ProximityReading, 2> sensors{ProximityReading{0.25F, 0.5F}, ProximityReading{1.0F, -3.0F}};
  Proximity proximity;
  proximity.sensors = Span<const ProximityReading>(sensors.data(), sensors.size());
  swarmanoid_msgs::ProximityArray message;
  toMessage(proximity, message);
  EXPECT_EQ(message.angles, (std::vector<float>{0.5F, -3.0F}));
  Proximity back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("proximity", &proximity), bytesOf("proximity", &back));
  message.angles.pop_back();
  EXPECT_EQ(refusalOf(message, proximity), "found 1 angles and 2 values, allowed: as many of both, at most 64");
}

TEST(FamilyMessages, KeepTheBatteryOfAnyRobot) {
  Battery battery;
  battery.charge = 66600.0F;
  battery.capacity = 133200.0F;
  battery.voltage = 3.7F;
  battery.power = 4.81F;
  sensor_msgs::BatteryState message;
  toMessage(battery, message);
  EXPECT_FLOAT_EQ(message.charge, 5.0F) << "A h";
  EXPECT_FLOAT_EQ(message.capacity, 10.0F);
  EXPECT_FLOAT_EQ(message.percentage, 0.5F);
  EXPECT_FLOAT_EQ(message.current, -1.3F);
  EXPECT_TRUE(std::isnan(message.temperature));
  EXPECT_TRUE(std::isnan(message.design_capacity));
  EXPECT_EQ(message.power_supply_status, sensor_msgs::BatteryState::POWER_SUPPLY_STATUS_DISCHARGING);
  EXPECT_TRUE(message.present != 0);
  Battery back;
  fromMessage(message, back);
  EXPECT_FLOAT_EQ(back.charge, battery.charge);
  EXPECT_FLOAT_EQ(back.capacity, battery.capacity);
  EXPECT_FLOAT_EQ(back.power, battery.power);
  EXPECT_EQ(back.voltage, battery.voltage);
  EXPECT_FALSE(back.is_charging);
  battery.is_charging = true;
  battery.on_capacitor = true;
  toMessage(battery, message);
  fromMessage(message, back);
  EXPECT_TRUE(back.is_charging);
  EXPECT_TRUE(back.on_capacitor);
  battery.is_charging = false;
  battery.charge = battery.capacity;
  toMessage(battery, message);
  EXPECT_EQ(message.power_supply_status, sensor_msgs::BatteryState::POWER_SUPPLY_STATUS_FULL);
  fromMessage(message, back);
  EXPECT_FALSE(back.is_charging);
  battery.is_charging = true;
  battery.power = 0.0F;
  toMessage(battery, message);
  EXPECT_EQ(message.power_supply_status, sensor_msgs::BatteryState::POWER_SUPPLY_STATUS_FULL)
      << "on a perch, which gives what the robot draws";
  fromMessage(message, back);
  EXPECT_TRUE(back.is_charging);
  message.charge = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusalOf(message, battery), "found no charge or no capacity (NaN: not measured), allowed: both");
  message.charge = 1.0F;
  message.voltage = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusalOf(message, battery), "found no voltage, allowed: 0 V or more");
}

TEST(FamilyMessages, KeepLightOfAnyRobot) {
  const std::array<LightReading, 2> sensors{LightReading{0.125F, -0.5F}, LightReading{1.0F, 3.0F}};
  Light light;
  light.sensors = Span<const LightReading>(sensors.data(), sensors.size());
  swarmanoid_msgs::LightArray message;
  toMessage(light, message);
  EXPECT_EQ(message.values, (std::vector<float>{0.125F, 1.0F}));
  Light back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("light", &light), bytesOf("light", &back));
  message.values.resize(65);
  message.angles.resize(65);
  EXPECT_EQ(refusalOf(message, light), "found 65 angles and 65 values, allowed: as many of both, at most 64");
}

TEST(FamilyMessages, KeepTheGroundUnderAnyRobot) {
  const std::array<GroundSpot, 2> spots{GroundSpot{0.125F, 0.03F, -0.02F}, GroundSpot{1.0F, -0.03F, 0.01F}};
  Ground ground;
  ground.sensors = Span<const GroundSpot>(spots.data(), spots.size());
  swarmanoid_msgs::GroundArray message;
  toMessage(ground, message);
  EXPECT_EQ(message.x, (std::vector<float>{0.03F, -0.03F}));
  EXPECT_EQ(message.y, (std::vector<float>{-0.02F, 0.01F}));
  Ground back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("ground", &ground), bytesOf("ground", &back));
  message.y.pop_back();
  EXPECT_EQ(refusalOf(message, ground), "found 2 x, 1 y and 2 values, allowed: as many of each, at most 64");
}

TEST(FamilyMessages, KeepWhatMicrophonesOfAnyRobotHear) {
  const std::array<Microphone, 2> microphones{Microphone{61.5F, 0.03F, -0.02F}, Microphone{30.0F, -0.03F, 0.01F}};
  Microphones heard;
  heard.sensors = Span<const Microphone>(microphones.data(), microphones.size());
  heard.loudest = {-2.5F, 0.75F, 440.0F};
  swarmanoid_msgs::MicrophoneLevels message;
  toMessage(heard, message);
  EXPECT_EQ(message.levels, (std::vector<float>{61.5F, 30.0F}));
  EXPECT_EQ(message.y, (std::vector<float>{-0.02F, 0.01F}));
  Microphones back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("microphones", &heard), bytesOf("microphones", &back));
  message.x.pop_back();
  EXPECT_EQ(refusalOf(message, heard), "found 1 x, 2 y and 2 levels, allowed: as many of each, at most 64");
}

TEST(FamilyMessages, KeepWhatAFootbotHears) {
  FootbotMicrophones heard;
  heard.level = {40.0F, 41.5F, 42.25F, 39.0F};
  heard.loudest = {1.5F, 0.125F, 880.0F};
  expectNothingLost<swarmanoid_msgs::MicrophoneLevels>(heard);
  swarmanoid_msgs::MicrophoneLevels message;
  toMessage(heard, message);
  EXPECT_EQ(message.x, (std::vector<float>{0.07F, 0.0F, -0.07F, 0.0F}));
  EXPECT_EQ(message.y, (std::vector<float>{0.0F, 0.07F, 0.0F, -0.07F}));
  message.levels.pop_back();
  EXPECT_EQ(refusalOf(message, heard), "found 3 levels, expected 4");
  message.levels.push_back(std::numeric_limits<float>::infinity());
  EXPECT_EQ(refusalOf(message, heard), "found a number that is not finite, allowed: finite numbers");
}

TEST(FamilyMessages, KeepTonesAndWhatIsWrittenToTags) {
  Loudspeaker speaker;
  speaker.sound(71.5, 523.25);
  expectNothingLost<swarmanoid_msgs::LoudspeakerCommand>(speaker);
  RfidWriter writer;
  writer.write(4294967295U, 4294967294U);
  expectNothingLost<swarmanoid_msgs::RfidWriteCommand>(writer);
}

TEST(FamilyMessages, KeepTagsInTheirOrder) {
  const std::array<RfidTagReading, 2> tags{RfidTagReading{4294967295U, 3}, RfidTagReading{1, 4294967295U}};
  RfidReader reader;
  reader.tags = Span<const RfidTagReading>(tags.data(), tags.size());
  reader.overflowed = true;
  swarmanoid_msgs::RfidTags message;
  toMessage(reader, message);
  EXPECT_EQ(message.ids, (std::vector<std::uint32_t>{4294967295U, 1}));
  RfidReader back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("rfid_reader", &reader), bytesOf("rfid_reader", &back));
  message.data.pop_back();
  EXPECT_EQ(refusalOf(message, reader), "found 2 ids and 1 data, allowed: as many of both, at most 16");
  message.ids.resize(17);
  message.data.resize(17);
  EXPECT_EQ(refusalOf(message, reader), "found 17 ids and 17 data, allowed: as many of both, at most 16");
}

TEST(FamilyMessages, KeepTheColourOfTheFloor) {
  for (const Color color : {Color{1, 254, 127}, Color{0, 0, 1}, colors::kWhite}) {
    expectNothingLost<swarmanoid_msgs::FloorColor>(FloorColor{color});
  }
  EXPECT_EQ(colors::kBlack, test::thereAndBack<swarmanoid_msgs::FloorColor>(FloorColor{}).color);
  swarmanoid_msgs::FloorColor message;
  toMessage(FloorColor{{51, 102, 153}}, message);
  EXPECT_FLOAT_EQ(0.2F, message.color.r);
  EXPECT_FLOAT_EQ(0.6F, message.color.b);
}

TEST(FamilyMessages, KeepJointsOfAnyRobotInTheirOrder) {
  Joints command;
  command.joints[0].holdAngle(0.25);
  command.joints[15].turnAt(-0.5);
  expectNothingLost<swarmanoid_msgs::JointsCommand>(command);
  const std::array<JointStates::Joint, 2> joints{JointStates::Joint{0.1, -0.2, 0.3},
                                                 JointStates::Joint{-1.0, 2.0, 0.5}};
  JointStates states;
  states.joints = Span<const JointStates::Joint>(joints.data(), joints.size());
  sensor_msgs::JointState message;
  message.name = {"of another message"};
  toMessage(states, message);
  EXPECT_TRUE(message.name.empty());
  EXPECT_EQ((std::vector<double>{-0.2, 2.0}), message.velocity);
  JointStates back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("joint_states", &states), bytesOf("joint_states", &back));
  message.name = {"elbow", "shoulder"};
  EXPECT_EQ("found 2 names, allowed: none, joints are known by their order here", refusalOf(message, states));
  message.name.clear();
  message.effort.pop_back();
  EXPECT_EQ("found 2 positions, 2 velocities and 1 efforts, allowed: as many of each, at most 16",
            refusalOf(message, states));
}

TEST(FamilyMessages, JointsBeyondTheMessageKeepTheirCommands) {
  Joints command;
  command.joints[1].holdAngle(0.75);
  swarmanoid_msgs::JointsCommand message;
  message.modes = {2};
  message.angles = {0.0};
  message.speeds = {0.0};
  fromMessage(message, command);
  EXPECT_EQ(Joints::Mode::kPassive, command.joints[0].mode);
  EXPECT_EQ(0.75, command.joints[1].angle);
  message.modes = {3};
  EXPECT_EQ("found mode 3 of joint 0, allowed: 0 (ANGLE), 1 (SPEED), 2 (PASSIVE)", refusalOf(message, command));
  message.modes = {0, 0};
  EXPECT_EQ("found 2 modes, 1 angles and 1 speeds, allowed: as many of each, at most 16", refusalOf(message, command));
}

TEST(FamilyMessages, KeepHoldersOfAnyRobot) {
  Holders command;
  command.holders[0].holds = true;
  command.holders[7].winding_speed = -0.125;
  expectNothingLost<swarmanoid_msgs::HoldersCommand>(command);
  swarmanoid_msgs::HoldersCommand shorter;
  shorter.holds = {0};
  shorter.winding_speeds = {0.5};
  fromMessage(shorter, command);
  EXPECT_FALSE(command.holders[0].holds);
  EXPECT_EQ(-0.125, command.holders[7].winding_speed) << "beyond the message";
  shorter.holds.resize(9);
  shorter.winding_speeds.resize(9);
  EXPECT_EQ("found 9 holds and 9 winding_speeds, allowed: as many of both, at most 8", refusalOf(shorter, command));

  const std::array<HolderStates::Holder, 2> holders{HolderStates::Holder{false, 0.0, 0.0},
                                                    HolderStates::Holder{true, 1.25, 28.5}};
  HolderStates states;
  states.holders = Span<const HolderStates::Holder>(holders.data(), holders.size());
  swarmanoid_msgs::HoldersState message;
  toMessage(states, message);
  EXPECT_EQ((std::vector<double>{0.0, 28.5}), message.forces);
  HolderStates back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("holder_states", &states), bytesOf("holder_states", &back));
  message.lengths.pop_back();
  EXPECT_EQ("found 2 is_holding, 1 lengths and 2 forces, allowed: as many of each, at most 8",
            refusalOf(message, states));
}

TEST(FamilyMessages, LedsWithoutAColourAreOff) {
  swarmanoid_msgs::LedArray message;
  message.colors.resize(2, toMessage(colors::kRed));
  Leds leds;
  leds.setAll(colors::kBlue);
  fromMessage(message, leds);
  EXPECT_EQ(leds.colors[1], colors::kRed);
  EXPECT_EQ(leds.colors[2], colors::kBlack);
  message.colors.resize(65);
  EXPECT_EQ(refusalOf(message, leds), "found 65 colours, allowed: at most 64");
}

}  // namespace
}  // namespace swarmanoid
