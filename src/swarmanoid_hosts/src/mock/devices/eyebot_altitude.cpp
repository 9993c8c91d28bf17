// An eyebot's altimeter measures the distance to the ground, and ignores objects on it.
#include "swarmanoid_interface/devices/eyebot_altitude.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebotAltitude final : public MockDevice {
 public:
  MockEyebotAltitude(EyebotAltitude& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    const Range range{EyebotAltitude::kNearest, EyebotAltitude::kUsualRange};
    readings_.distance = Distance::reading(state.pose.position.z(), range);
  }

 private:
  EyebotAltitude& readings_;
};

REGISTER_MOCK_DEVICE(EyebotAltitude, MockEyebotAltitude)

}  // namespace
}  // namespace swarmanoid::mock
