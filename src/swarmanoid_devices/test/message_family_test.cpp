// A radio built from the base classes of messages: this file has all that such a device needs.
#include <gtest/gtest.h>

#include <vector>

#include "actuators/messages/message_sender.hpp"
#include "device_world.hpp"
#include "sensors/messages/message_receiver.hpp"
#include "swarmanoid_interface/devices/messages.hpp"

namespace swarmanoid::test {
namespace {

struct Radio : MessageCommand<3> {
  static constexpr const char* kType = "radio_of_a_test";
  static constexpr const char* kLink = "antenna";
};
REGISTER_DEVICE(Radio, kActuator, "Sends far.")

struct RadioMessage {
  Radio::Payload payload{};

  void measure(const Eigen::Vector3d& /*offset*/) {}
};
template <class Visitor>
void fields(Visitor& visit, RadioMessage& message) {
  visit(message.payload, {"payload"});
}

struct RadioReceived : ReceivedMessages<RadioMessage> {
  static constexpr const char* kType = "radio_received_of_a_test";
  static constexpr double kUsualRange = 5.0;  // m
  static constexpr bool kNeedsSight = false;
};
REGISTER_DEVICE(RadioReceived, kSensor, "Hears far.")

class RadioSender final : public devices::MessageSender<Radio> {
 public:
  static PluginDescription describe() { return describeSender("A radio."); }
};

class RadioReceiver final : public devices::MessageReceiver<RadioReceived, Radio> {
 public:
  static PluginDescription describe() { return describeReceiver("A radio."); }
};

Configuration usualParameters() {
  Configuration configuration("radio", "", {});
  for (const Parameter& parameter : RadioReceiver::describe().parameters) {
    configuration.set(parameter.name, parameter.value.value_or(""));
  }
  return configuration;
}

TEST(MessageFamilyTest, ARadioIsAFewLines) {
  EXPECT_EQ("(u1 u1 u1)* b1", findDeviceType("radio_received_of_a_test")->layout);
  DeviceWorld world;
  RadioSender sender;
  RadioReceiver receiver;
  receiver.configure(usualParameters());
  const Row a = world.addFootbot(2.0, 5.0);
  const Row b = world.addFootbot(6.9, 5.0);
  const Row c = world.addFootbot(7.1, 5.0);
  world.addWall({0.1, 4.0, 1.0}, {4.0, 5.0});
  std::vector<const RadioReceived*> received;
  for (const Row row : {a, b, c}) {
    received.push_back(static_cast<const RadioReceived*>(receiver.add(world.space, row)));
  }
  static_cast<Radio*>(sender.add(world.space, a))->send({7, 8, 9});
  world.actuate(sender);
  ++world.space.tick;
  world.sense(receiver);
  EXPECT_TRUE(received[0]->messages.empty());
  ASSERT_EQ(1U, received[1]->messages.size()) << "through the wall";
  EXPECT_EQ((Radio::Payload{7, 8, 9}), received[1]->messages[0].payload);
  EXPECT_TRUE(received[2]->messages.empty()) << "5.1 m away";
}

}  // namespace
}  // namespace swarmanoid::test
