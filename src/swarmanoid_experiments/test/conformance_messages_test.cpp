// The conformance test of communication devices, with a partner that answers: it passes with correct wiring, and
// detects and names each wrongly wired device.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "conformance_world.hpp"
#include "swarmanoid_interface/devices/bluetooth.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "swarmanoid_interface/devices/wifi.hpp"

namespace swarmanoid::test {
namespace {

/// The partner stands 1.2 m away, ahead and to the left of the robot.
constexpr const char* kTalkers = R"(<?xml version="1.0"?>
<ahss-config>
  <framework><clocktick>100</clocktick><maxclock>1500</maxclock></framework>
  <controllers>
    <conformance id="test" library="conformance">
      <actuators><differential_drive/><range_and_bearing/><wifi/><bluetooth/></actuators>
      <sensors><range_and_bearing_received/><wifi_received/><bluetooth_received/></sensors>
      <parameters>
        <partner>p</partner><partner_distance>1.2</partner_distance><partner_bearing>50</partner_bearing>
        <answer_time>0.2</answer_time>
      </parameters>
    </conformance>
    <conformance id="observer" library="conformance">
      <actuators><range_and_bearing/><wifi/><bluetooth/></actuators>
      <sensors><range_and_bearing_received/><wifi_received/><bluetooth_received/></sensors>
      <parameters><role>observer</role></parameters>
    </conformance>
  </controllers>
  <arena size="5,5,1" optimization="2D">
    <footbot id="r">
      <position>2, 2, 0</position><orientation>0, 0, 40</orientation><controller>test</controller>
    </footbot>
    <footbot id="p">
      <position>2, 3.2, 0</position><orientation>0, 0, 0</orientation><controller>observer</controller>
    </footbot>
  </arena>
  <engines><kinematics2d id="ground"/></engines>
  <arena_physics><engine id="ground"><entity id="r"/><entity id="p"/></engine></arena_physics>
  <visualisations><verdict_monitor id="verdict" library="verdict_monitor"/></visualisations>
</ahss-config>
)";

template <class Received, class Change>
Miswiring wireMessages(Change change) {
  return wireList<Received>(&Received::messages, change);
}

/// @param change function that changes each message
template <class Received, class Change>
Miswiring wireEach(Change change) {
  return wireMessages<Received>([change](std::vector<typename Received::Message>& messages) {
    for (auto& message : messages) {
      change(message);
    }
  });
}

/// Messages arrive one tick late.
template <class Received>
Miswiring late() {
  using Messages = std::vector<typename Received::Message>;
  return wireMessages<Received>(
      [last = std::make_shared<Messages>()](Messages& messages) { std::swap(messages, *last); });
}

/// The last received messages repeat for ever.
template <class Received>
Miswiring lasting() {
  using Messages = std::vector<typename Received::Message>;
  return wireMessages<Received>([last = std::make_shared<Messages>()](Messages& messages) {
    if (messages.empty()) {
      messages = *last;
    }
    *last = messages;
  });
}

/// The robot also receives its own message, which is its answer with all bits inverted.
template <class Received>
Miswiring hearingItself() {
  return wireMessages<Received>([](std::vector<typename Received::Message>& messages) {
    if (!messages.empty() && messages[0].payload[0] != 0x71) {
      messages.push_back(messages[0]);
      for (std::uint8_t& byte : messages.back().payload) {
        byte = static_cast<std::uint8_t>(~byte);
      }
    }
  });
}

/// The sender never stops.
template <class Device>
Miswiring endless() {
  return wire<Device>([last = Device{}](Device& device) mutable {
    if (device.sends) {
      last = device;
    }
    device = last;
  });
}

TEST(ConformanceMessagesTest, PassesWhatIsWiredRightly) {
  const auto simulation = start(kTalkers);
  const auto verdicts = fullVerdictsOf(*simulation);
  EXPECT_EQ((std::map<std::string, std::string>{{"p", "passed"}, {"r", "passed"}}), verdicts);
  EXPECT_EQ("bluetooth, range_and_bearing, wifi, range_and_bearing_turns", debugOf(*simulation, "r", "passed"));
  EXPECT_EQ("bluetooth_of_the_other, range_and_bearing_of_the_other, wifi_of_the_other",
            debugOf(*simulation, "p", "passed"));
}

TEST(ConformanceMessagesTest, WithoutAPartnerItSaysSo) {
  std::string text = kTalkers;
  replace(text, "<partner>p</partner>", "");
  const auto simulation = start(text);
  fullVerdictsOf(*simulation);
  EXPECT_NE(std::string::npos,
            debugOf(*simulation, "r", "unchecked").find("wifi (nobody answers here (partner is not"));
  EXPECT_EQ(
      "bluetooth, bluetooth_received, differential_drive, range_and_bearing, range_and_bearing_received, wifi, "
      "wifi_received",
      debugOf(*simulation, "r", "unchecked_devices"));
}

TEST(ConformanceMessagesTest, FindsWhereAPartnerIsNot) {
  using Received = RangeAndBearingReceived;
  using Message = RangeAndBearingMessage;
  const std::string at_bearing = "range_and_bearing (range_and_bearing: bearing of the partner: ";
  expectFailure(kTalkers, "r", wireEach<Received>([](Message& message) { message.bearing = -message.bearing; }),
                at_bearing + "-0.87");
  expectFailure(kTalkers, "r", wireEach<Received>([](Message& message) { message.bearing += 1.5708F; }), at_bearing);
  expectFailure(kTalkers, "r",
                wireEach<Received>([](Message& message) { message.bearing *= static_cast<float>(kDegrees); }),
                at_bearing);
  expectFailure(kTalkers, "r", wireEach<Received>([](Message& message) { message.range *= 100.0F; }),
                "range_and_bearing (range_and_bearing: range of the partner: 120.000 m, expected 1.200 m");
  expectFailure(kTalkers, "r", wireEach<Received>([](Message& message) { message.bearing = 0.87F; }),
                "range_and_bearing_turns (range_and_bearing_turns: turned left, the partner's bearing changed by: ");
}

TEST(ConformanceMessagesTest, FindsAPartnerThatIsAboveInsteadOfBelow) {
  expectFailure(conformanceText(), "eb",
                wireEach<RangeAndBearingReceived>([](RangeAndBearingMessage& message) { message.elevation *= -1.0F; }),
                "range_and_bearing (range_and_bearing: elevation of the partner: 1.1");
}

template <class Device, class Received>
void expectMistakesAreFound() {
  const std::string name = Device::kType;
  const std::string failed = name + " (" + name + ": ";
  const std::string unanswered = failed + "an answer of the partner: not within 10.000 s";
  expectFailure(kTalkers, "r", late<Received>(), failed + "an answer to something new: not within 0.200 s");
  expectFailure(kTalkers, "r", lasting<Received>(), failed + "not true: while it is silent, nobody answers it");
  expectFailure(kTalkers, "r", hearingItself<Received>(), failed + "the robot hears itself");
  expectFailure(kTalkers, "r", endless<Device>(), failed + "not true: while it is silent, nobody answers it");
  expectFailure(kTalkers, "r", wireEach<Received>([](typename Received::Message& message) {
                  std::rotate(message.payload.begin(), message.payload.begin() + 1, message.payload.end());
                }),
                unanswered);
  expectFailure(kTalkers, "r", wire<Device>([](Device& device) { device.payload.back() = 0; }), unanswered);
}

TEST(ConformanceMessagesTest, FindsMessagesThatAreLateEndlessItsOwnOrCut) {
  expectMistakesAreFound<RangeAndBearing, RangeAndBearingReceived>();
}

template <class Device, class Received>
void expectRadioMistakesAreFound() {
  const std::string failed = std::string(Device::kType) + " (" + Device::kType + ": ";
  expectFailure(kTalkers, "r", wireEach<Received>([](typename Received::Message& message) { ++message.sender; }),
                failed + "not true: the sender's address is the partner's");
  expectFailure(kTalkers, "r", wire<Device>([](Device& device) { device.to = kEverybody; }),
                failed + "not true: while it is talking to another robot, nobody answers it");
  expectFailure(kTalkers, "r", wire<Device>([](Device& device) {
                  device.to = device.to == kEverybody ? kEverybody : device.to >> 8U;
                }),
                failed + "an answer to what is for the partner alone: not within 0.200 s");
  expectFailure(kTalkers, "r",
                wireEach<Received>([](typename Received::Message& message) { message.payload.fill(0x71); }),
                failed + "the robot hears what is for another one");
}

TEST(ConformanceMessagesTest, FindsRadiosThatAreWiredWrongly) {
  expectMistakesAreFound<Wifi, WifiReceived>();
  expectMistakesAreFound<Bluetooth, BluetoothReceived>();
  expectRadioMistakesAreFound<Wifi, WifiReceived>();
  expectRadioMistakesAreFound<Bluetooth, BluetoothReceived>();
}

}  // namespace
}  // namespace swarmanoid::test
