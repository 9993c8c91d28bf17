// Devices that receive messages hear the beacons of the world that say something, radios by the addresses of their
// names, and nobody hears them: a mock robot is alone. Boards and antennas are at the robot's origin, a beacon's where
// that is, and nothing is lost or hidden.
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

template <class Received>
class MockReceivedMessages final : public MockDevice {
  using Message = typename Received::Message;
  static_assert(Beacon::kMostBytes <= sizeof(Message::payload), "a device may receive as much as a beacon says");

 public:
  MockReceivedMessages(Received& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    messages_.clear();
    for (const Beacon& beacon : state.world.beacons) {
      const Eigen::Vector3d offset = state.pose.toRobot(beacon.at);
      if (beacon.says.empty() || offset.norm() > Received::kUsualRange) {
        continue;
      }
      Message& message = messages_.emplace_back();
      message.measure(offset);
      setSender(message, beacon);
      std::copy_n(beacon.says.begin(), std::min(beacon.says.size(), message.payload.size()), message.payload.begin());
    }
    const std::size_t count = std::min(messages_.size(), std::size_t{Received::kMostMessages});
    readings_.messages = Span<const Message>(messages_.data(), count);
    readings_.overflowed = messages_.size() > count;
  }

 private:
  Received& readings_;
  std::vector<Message> messages_;
};

REGISTER_MOCK_DEVICE(RangeAndBearingReceived, MockReceivedMessages<RangeAndBearingReceived>)
REGISTER_MOCK_DEVICE(WifiReceived, MockReceivedMessages<WifiReceived>)
REGISTER_MOCK_DEVICE(BluetoothReceived, MockReceivedMessages<BluetoothReceived>)

}  // namespace
}  // namespace swarmanoid::mock
