// The contact switch of an eyebot's magnet.
#include "../mock_device.hpp"
#include "swarmanoid_interface/devices/eyebot_magnet.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebotMagnetState final : public MockDevice {
 public:
  MockEyebotMagnetState(EyebotMagnetState& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override { readings_.attached = state.holder("magnet").is_holding; }

 private:
  EyebotMagnetState& readings_;
};

REGISTER_MOCK_DEVICE(EyebotMagnetState, MockEyebotMagnetState)

}  // namespace
}  // namespace swarmanoid::mock
