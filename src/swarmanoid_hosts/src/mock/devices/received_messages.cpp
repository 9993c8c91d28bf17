// Devices that receive messages get those of the beacons of the world that send or answer. A beacon's radio address is
// that of its name. Only beacons receive the robot's messages. Boards and antennas are at the origins of robot and
// beacon, and no message is lost or blocked.
#include <algorithm>
#include <vector>

#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/bluetooth.hpp"
#include "swarmanoid_interface/devices/range_and_bearing.hpp"
#include "swarmanoid_interface/devices/wifi.hpp"

namespace swarmanoid::mock {
namespace {

static_assert(Beacon::kMostBytes == RangeAndBearing::kBytes, "a beacon may say as much as a robot");

void setSender(RangeAndBearingMessage& /*message*/, const Beacon& /*beacon*/) {}

template <std::size_t byte_count>
void setSender(RadioMessage<byte_count>& message, const Beacon& beacon) {
  message.sender = addressOf(beacon.name);
}

RadioAddress addressee(const RangeAndBearing& /*command*/) { return kEverybody; }

template <std::size_t byte_count>
RadioAddress addressee(const RadioCommand<byte_count>& command) {
  return command.to;
}

template <class Command>
class MockSender final : public MockDevice {
 public:
  MockSender(const Command& command, MockState& /*state*/) : command_(command) {}

  void act(MockState& state, double /*dt*/) override {
    if (command_.sends) {
      state.sayings[Command::kType] = {{command_.payload.begin(), command_.payload.end()}, addressee(command_)};
    } else {
      state.sayings.erase(Command::kType);
    }
  }

 private:
  const Command& command_;
};

/// @tparam Command the device that sends the messages
template <class Command, class Received>
class MockReceivedMessages final : public MockDevice {
  using Message = typename Received::Message;
  static_assert(Beacon::kMostBytes <= sizeof(Message::payload), "a device may receive as much as a beacon says");

 public:
  MockReceivedMessages(Received& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    messages_.clear();
    for (const Beacon& beacon : state.world.beacons) {
      const Eigen::Vector3d offset = state.pose.toRobot(beacon.at);
      if (offset.norm() > Received::kUsualRange) {
        continue;
      }
      if (!beacon.says.empty()) {
        add(beacon, offset, beacon.says);
      }
      if (beacon.answers) {
        answer(beacon, offset, state);
      }
    }
    const std::size_t count = std::min(messages_.size(), std::size_t{Received::kMostMessages});
    readings_.messages = Span<const Message>(messages_.data(), count);
    readings_.overflowed = messages_.size() > count;
  }

 private:
  void add(const Beacon& beacon, const Eigen::Vector3d& offset, const std::vector<std::uint8_t>& bytes) {
    Message& message = messages_.emplace_back();
    message.measure(offset);
    setSender(message, beacon);
    std::copy_n(bytes.begin(), std::min(bytes.size(), message.payload.size()), message.payload.begin());
  }

  void answer(const Beacon& beacon, const Eigen::Vector3d& offset, const MockState& state) {
    const auto said = state.sayings.find(Command::kType);
    if (said == state.sayings.end() || (said->second.to != kEverybody && said->second.to != addressOf(beacon.name))) {
      return;
    }
    std::vector<std::uint8_t> bytes = said->second.payload;
    for (std::uint8_t& byte : bytes) {
      byte = static_cast<std::uint8_t>(~byte);
    }
    add(beacon, offset, bytes);
  }

  Received& readings_;
  std::vector<Message> messages_;
};

REGISTER_MOCK_DEVICE(RangeAndBearing, MockSender<RangeAndBearing>)
using MockRangeAndBearingReceived = MockReceivedMessages<RangeAndBearing, RangeAndBearingReceived>;
REGISTER_MOCK_DEVICE(RangeAndBearingReceived, MockRangeAndBearingReceived)
REGISTER_MOCK_DEVICE(Wifi, MockSender<Wifi>)
using MockWifiReceived = MockReceivedMessages<Wifi, WifiReceived>;
REGISTER_MOCK_DEVICE(WifiReceived, MockWifiReceived)
REGISTER_MOCK_DEVICE(Bluetooth, MockSender<Bluetooth>)
using MockBluetoothReceived = MockReceivedMessages<Bluetooth, BluetoothReceived>;
REGISTER_MOCK_DEVICE(BluetoothReceived, MockBluetoothReceived)

}  // namespace
}  // namespace swarmanoid::mock
