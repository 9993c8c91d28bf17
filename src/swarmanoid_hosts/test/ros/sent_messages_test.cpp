// Converts the messages that robots send to each other, by range and bearing and by radio, to ROS messages and back.
#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "message_bench.hpp"
#include "swarmanoid_hosts/ros/devices/bluetooth.hpp"
#include "swarmanoid_hosts/ros/devices/range_and_bearing.hpp"
#include "swarmanoid_hosts/ros/devices/wifi.hpp"

namespace swarmanoid {
namespace {

using test::bytesOf;
using test::expectNothingLost;
using test::refusalOf;

TEST(SentMessages, KeepWhatIsSentByRangeAndBearing) {
  RangeAndBearing command;
  command.send({255, 0, 1, 2, 3, 4, 5, 6, 7, 128});
  expectNothingLost<swarmanoid_msgs::MessageCommand>(command);
  swarmanoid_msgs::MessageCommand message;
  message.payload = {9, 8};
  message.sends = 1;
  fromMessage(message, command);
  EXPECT_EQ(command.payload, (RangeAndBearing::Payload{9, 8})) << "what is missing is 0";
  EXPECT_TRUE(command.sends);
  message.payload.resize(11);
  EXPECT_EQ(refusalOf(message, command), "found a payload of 11 bytes, allowed: at most 10");
}

TEST(SentMessages, KeepWhatIsReceivedByRangeAndBearing) {
  std::array<RangeAndBearingMessage, 2> messages;
  messages[0] = {1.5F, -2.5F, 0.25F, {1, 2, 3, 4, 5, 6, 7, 8, 9, 255}};
  messages[1] = {0.125F, 3.0F, -1.25F, {128}};
  RangeAndBearingReceived received;
  received.messages = Span<const RangeAndBearingMessage>(messages.data(), messages.size());
  received.overflowed = true;
  swarmanoid_msgs::RangeAndBearingMessages message;
  toMessage(received, message);
  ASSERT_EQ(2U, message.messages.size());
  EXPECT_EQ(-1.25F, message.messages[1].elevation);
  EXPECT_EQ(255, message.messages[0].payload.at(9));
  RangeAndBearingReceived back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("range_and_bearing_received", &received), bytesOf("range_and_bearing_received", &back));
  message.messages[1].payload.resize(12);
  EXPECT_EQ(refusalOf(message, received), "found a payload of 12 bytes, allowed: at most 10");
  message.messages[1].payload.clear();
  message.messages[1].range = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusalOf(message, received), "found a number that is not finite, allowed: finite numbers");
  message.messages.resize(65);
  EXPECT_EQ(refusalOf(message, received), "found 65 messages, allowed: at most 64");
}

TEST(SentMessages, KeepWhatRadiosSend) {
  Wifi::Payload payload{};
  payload[0] = 255;
  payload[127] = 9;
  Wifi command;
  command.send(payload, (RadioAddress{1} << 48U) - 1);
  expectNothingLost<swarmanoid_msgs::RadioCommand>(command);
  Bluetooth shorter;
  shorter.send({1, 2, 3});
  expectNothingLost<swarmanoid_msgs::RadioCommand>(shorter);
  swarmanoid_msgs::RadioCommand message;
  message.payload.resize(28);
  EXPECT_EQ(refusalOf(message, shorter), "found a payload of 28 bytes, allowed: at most 27");
}

TEST(SentMessages, KeepWhatRadiosReceive) {
  std::array<BluetoothMessage, 2> messages;
  messages[0].sender = addressOf("fb_1");
  messages[0].payload = {1, 2, 255};
  messages[1].sender = 7;
  messages[1].payload[26] = 128;
  BluetoothReceived received;
  received.messages = Span<const BluetoothMessage>(messages.data(), messages.size());
  received.overflowed = true;
  swarmanoid_msgs::RadioMessages message;
  toMessage(received, message);
  ASSERT_EQ(2U, message.messages.size());
  EXPECT_EQ(22510536293955U, message.messages[0].sender);
  EXPECT_EQ(128, message.messages[1].payload.at(26));
  BluetoothReceived back;
  VariableParts parts;
  fromMessage(message, back, parts);
  EXPECT_EQ(bytesOf("bluetooth_received", &received), bytesOf("bluetooth_received", &back));
  message.messages.resize(8);
  EXPECT_EQ(refusalOf(message, received), "found 8 messages, allowed: at most 7");
  EXPECT_EQ(refusalOf(message, WifiReceived{}), "") << "that is more on another channel";
}

}  // namespace
}  // namespace swarmanoid
