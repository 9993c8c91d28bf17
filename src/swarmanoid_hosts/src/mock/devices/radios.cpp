// Radios hear the beacons of the world that say something, by the addresses of their names, and nobody hears them: a
// mock robot is alone. Nothing is lost.
#include <algorithm>
#include <vector>

#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/bluetooth.hpp"
#include "swarmanoid_interface/devices/wifi.hpp"

namespace swarmanoid::mock {
namespace {

template <class Received>
class MockRadioReceived final : public MockDevice {
  using Message = typename Received::Message;
  static_assert(Beacon::kMostBytes <= sizeof(Message::payload), "a radio may say as much as a beacon");

 public:
  MockRadioReceived(Received& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    messages_.clear();
    for (const Beacon& beacon : state.world.beacons) {
      if (beacon.says.empty() || state.pose.toRobot(beacon.at).norm() > Received::kUsualRange) {
        continue;
      }
      Message& message = messages_.emplace_back();
      message.sender = addressOf(beacon.name);
      std::copy(beacon.says.begin(), beacon.says.end(), message.payload.begin());
    }
    const std::size_t count = std::min(messages_.size(), std::size_t{Received::kMostMessages});
    readings_.messages = Span<const Message>(messages_.data(), count);
    readings_.overflowed = messages_.size() > count;
  }

 private:
  Received& readings_;
  std::vector<Message> messages_;
};

REGISTER_MOCK_DEVICE(WifiReceived, MockRadioReceived<WifiReceived>)
REGISTER_MOCK_DEVICE(BluetoothReceived, MockRadioReceived<BluetoothReceived>)

}  // namespace
}  // namespace swarmanoid::mock
