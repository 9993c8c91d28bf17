// The message of devices without a message of their own.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "swarmanoid_hosts/ros/device_fields.hpp"
#include "swarmanoid_hosts/ros/device_topic.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

namespace swarmanoid {
namespace {

struct Echo {
  float range = 0.0F;
  std::uint8_t channel = 0;
};
template <class Visitor>
void fields(Visitor& visit, Echo& echo) {
  visit(echo.range, {"range", "m"});
  visit(echo.channel, {"channel"});
}

/// A device with every kind of field, and without a topic.
struct Sonar {
  static constexpr const char* kType = "sonar";
  double bearing = 0.25;
  std::array<std::int16_t, 2> gains = {3, 4};
  bool is_on = true;
  Span<const Echo> echoes;
};
template <class Visitor>
void fields(Visitor& visit, Sonar& sonar) {
  visit(sonar.bearing, {"bearing", "rad"});
  visit(sonar.gains, {"gains"});
  visit(sonar.is_on, {"is_on"});
  visit(sonar.echoes, {"echoes"});
}
REGISTER_DEVICE(Sonar, kSensor, "Distances by sound.")

struct Horn {
  static constexpr const char* kType = "horn";
  double pitch = 0.0;
};
template <class Visitor>
void fields(Visitor& visit, Horn& horn) {
  visit(horn.pitch, {"pitch", "Hz"});
}
REGISTER_DEVICE(Horn, kActuator, "A sound.")

using Message = swarmanoid_msgs::DeviceFields;
using Names = std::vector<std::string>;

Message messageOf(const std::vector<std::pair<std::string, double>>& values) {
  Message message;
  for (const auto& [name, value] : values) {
    message.names.push_back(name);
    message.values.push_back(value);
  }
  return message;
}

/// Returns the reason why a sonar refuses the message, which must then leave it unchanged; "" if it is accepted.
std::string refusalOf(const Message& message) {
  Sonar sonar;
  VariableParts parts;
  try {
    fromMessage(message, *findDeviceType("sonar"), &sonar, parts);
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(0.25, sonar.bearing);
    EXPECT_EQ(4, sonar.gains[1]);
    EXPECT_TRUE(sonar.echoes.empty());
    return error.what();
  }
  return "";
}

TEST(DeviceFieldsTest, TheStatusHasAUnitForEachNumber) {
  const std::array<Echo, 2> echoes = {{{1.5F, 7}, {0.5F, 9}}};
  Sonar sonar;
  sonar.echoes = Span<const Echo>(echoes.data(), echoes.size());
  const swarmanoid_msgs::DeviceStatus status = statusOf(*findDeviceType("sonar"), &sonar);
  EXPECT_EQ("sonar", status.type);
  EXPECT_EQ(0, status.is_actuator);
  EXPECT_EQ((Names{"bearing", "gains[0]", "gains[1]", "is_on", "echoes[0].range", "echoes[0].channel",
                   "echoes[1].range", "echoes[1].channel"}),
            status.names);
  EXPECT_EQ((std::vector<double>{0.25, 3.0, 4.0, 1.0, 1.5, 7.0, 0.5, 9.0}), status.values);
  EXPECT_EQ((Names{"rad", "", "", "", "m", "", "m", ""}), status.units);
  const Horn horn;
  EXPECT_EQ(1, statusOf(*findDeviceType("horn"), &horn).is_actuator);
}

TEST(DeviceFields, NamesEveryNumberAndKeepsItsBits) {
  const std::array<Echo, 2> echoes = {Echo{0.1F, 255}, Echo{-3.7e-5F, 7}};
  Sonar sonar;
  sonar.bearing = -1.0 / 3.0;
  sonar.gains = {-32768, 32767};
  sonar.is_on = false;
  sonar.echoes = Span<const Echo>(echoes.data(), echoes.size());
  Message message;
  toMessage(*findDeviceType("sonar"), &sonar, message);
  EXPECT_EQ((std::vector<std::string>{"bearing", "gains[0]", "gains[1]", "is_on", "echoes[0].range",
                                      "echoes[0].channel", "echoes[1].range", "echoes[1].channel"}),
            message.names);
  EXPECT_EQ((std::vector<double>{-1.0 / 3.0, -32768.0, 32767.0, 0.0, static_cast<double>(0.1F), 255.0,
                                 static_cast<double>(-3.7e-5F), 7.0}),
            message.values);

  Sonar back;
  VariableParts parts;
  fromMessage(message, *findDeviceType("sonar"), &back, parts);
  EXPECT_EQ(sonar.bearing, back.bearing);
  EXPECT_EQ(sonar.gains, back.gains);
  EXPECT_FALSE(back.is_on);
  ASSERT_EQ(2U, back.echoes.size());
  EXPECT_EQ(echoes[1].range, back.echoes[1].range);
  EXPECT_EQ(255, back.echoes[0].channel);
}

TEST(DeviceFields, NameTheNumbersOfArraysInElements) {
  std::array<RangeAndBearingMessage, 2> messages;
  messages[0] = {1.5F, -2.5F, 0.25F, {1, 2, 3, 4, 5, 6, 7, 8, 9, 255}};
  messages[1].payload = {128, 64};
  RangeAndBearingReceived received;
  received.messages = Span<const RangeAndBearingMessage>(messages.data(), messages.size());
  const DeviceType& type = *findDeviceType("range_and_bearing_received");
  Message message;
  toMessage(type, &received, message);
  ASSERT_EQ(27U, message.names.size());
  EXPECT_EQ("messages[0].payload[9]", message.names[12]);
  EXPECT_EQ(255.0, message.values[12]);
  EXPECT_EQ("messages[1].payload[1]", message.names[17]);

  RangeAndBearingReceived back;
  VariableParts parts;
  fromMessage(message, type, &back, parts);
  ASSERT_EQ(2U, back.messages.size());
  EXPECT_EQ(messages[0].payload, back.messages[0].payload);
  EXPECT_EQ(messages[1].payload, back.messages[1].payload);
  EXPECT_EQ(-2.5F, back.messages[0].bearing);
  message.values[12] = 256.0;
  try {
    fromMessage(message, type, &back, parts);
    FAIL() << "is no byte";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ("found 256 for 'messages[0].payload[9]', allowed: whole numbers from 0 to 255", error.what());
  }
}

TEST(DeviceFields, WhatIsNotNamedStaysAndListsAreWhatIsNamed) {
  const Echo echo{2.5F, 1};
  Sonar sonar;
  sonar.gains = {17, 19};
  sonar.echoes = Span<const Echo>(&echo, 1);
  VariableParts parts;
  fromMessage(messageOf({{"gains[1]", -5.0}}), *findDeviceType("sonar"), &sonar, parts);
  EXPECT_EQ(0.25, sonar.bearing);
  EXPECT_EQ(17, sonar.gains[0]);
  EXPECT_EQ(-5, sonar.gains[1]);
  EXPECT_TRUE(sonar.is_on);
  EXPECT_TRUE(sonar.echoes.empty());
}

TEST(DeviceFields, RefusesWhatTheDeviceCannotHold) {
  Message uneven = messageOf({{"bearing", 1.0}});
  uneven.names.push_back("is_on");
  EXPECT_EQ("found 2 names and 1 values, allowed: as many values as names", refusalOf(uneven));
  EXPECT_EQ("found 'is_on' twice, allowed: once", refusalOf(messageOf({{"is_on", 1.0}, {"is_on", 1.0}})));
  EXPECT_EQ(
      "found 'baering', allowed: bearing, gains[0], gains[1], is_on, echoes[].range, echoes[].channel, elements of "
      "lists from 0 on without a gap; did you mean 'bearing'?",
      refusalOf(messageOf({{"gains[0]", 9.0}, {"baering", 1.0}})));
  EXPECT_EQ("found 32768 for 'gains[1]', allowed: whole numbers from -32768 to 32767",
            refusalOf(messageOf({{"bearing", 2.0}, {"gains[1]", 32768.0}})));
  EXPECT_EQ("found 0.5 for 'is_on', allowed: whole numbers from 0 to 1", refusalOf(messageOf({{"is_on", 0.5}})));
  EXPECT_EQ("found a number that is not finite for 'bearing', allowed: finite numbers",
            refusalOf(messageOf({{"bearing", std::numeric_limits<double>::quiet_NaN()}})));
  EXPECT_EQ("found no 'echoes[0].channel', expected all numbers of an element",
            refusalOf(messageOf({{"echoes[0].range", 1.0}})));
  const std::string gap = refusalOf(messageOf({{"echoes[1].range", 1.0}, {"echoes[1].channel", 1.0}}));
  EXPECT_EQ(0U, gap.find("found 'echoes[1].channel', allowed: ")) << gap;
}

TEST(DeviceFields, AreTheTopicOfDevicesWithoutOne) {
  const DeviceTopic* reading = mainTopicOf("sonar");
  ASSERT_NE(nullptr, reading);
  EXPECT_EQ("sonar", reading->name);
  EXPECT_EQ("swarmanoid_msgs/DeviceFields", reading->message);
  EXPECT_EQ("base_link", reading->frame);
  EXPECT_EQ(DeviceTopic::Kind::kReading, reading->kind);
  EXPECT_EQ(reading, mainTopicOf("sonar")) << "made once";
  const DeviceTopic* command = mainTopicOf("horn");
  ASSERT_NE(nullptr, command);
  EXPECT_EQ("horn/command", command->name);
  EXPECT_EQ(DeviceTopic::Kind::kCommand, command->kind);
  EXPECT_EQ("swarmanoid_msgs/GripperState", mainTopicOf("footbot_gripper_state")->message) << "has its own";
  EXPECT_EQ(nullptr, mainTopicOf("trumpet"));
}

}  // namespace
}  // namespace swarmanoid
