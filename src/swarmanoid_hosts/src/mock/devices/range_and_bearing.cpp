// A board of range and bearing hears the beacons of the world that say something, and nobody hears it: a mock robot is
// alone. Its transmitter is at the robot's origin, a beacon's where that is, and nothing hides anything.
#include "swarmanoid_interface/devices/range_and_bearing.hpp"

#include <algorithm>
#include <vector>

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

static_assert(Beacon::kMostBytes == RangeAndBearing::kBytes, "a beacon may say as much as a robot");

class MockRangeAndBearingReceived final : public MockDevice {
 public:
  MockRangeAndBearingReceived(RangeAndBearingReceived& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    messages_.clear();
    for (const Beacon& beacon : state.world.beacons) {
      const Eigen::Vector3d offset = state.pose.toRobot(beacon.at);
      if (beacon.says.empty() || offset.norm() > RangeAndBearingReceived::kUsualRange) {
        continue;
      }
      RangeAndBearingMessage& message = messages_.emplace_back();
      message.measure(offset);
      std::copy_n(beacon.says.begin(), std::min(beacon.says.size(), message.payload.size()), message.payload.begin());
    }
    const std::size_t count = std::min(messages_.size(), RangeAndBearingReceived::kMostMessages);
    readings_.messages = Span<const RangeAndBearingMessage>(messages_.data(), count);
    readings_.overflowed = messages_.size() > count;
  }

 private:
  RangeAndBearingReceived& readings_;
  std::vector<RangeAndBearingMessage> messages_;
};

REGISTER_MOCK_DEVICE(RangeAndBearingReceived, MockRangeAndBearingReceived)

}  // namespace
}  // namespace swarmanoid::mock
