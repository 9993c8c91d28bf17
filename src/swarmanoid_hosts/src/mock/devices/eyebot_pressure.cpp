// An eyebot's barometer was set to 0 on the ground.
#include "swarmanoid_interface/devices/eyebot_pressure.hpp"

#include "../mock_device.hpp"

namespace swarmanoid::mock {
namespace {

class MockEyebotPressure final : public MockDevice {
 public:
  MockEyebotPressure(EyebotPressure& readings, MockState& /*state*/) : readings_(readings) {}

  void sense(const MockState& state) override {
    readings_.difference = EyebotPressure::differenceAt(state.pose.position.z());
  }

 private:
  EyebotPressure& readings_;
};

REGISTER_MOCK_DEVICE(EyebotPressure, MockEyebotPressure)

}  // namespace
}  // namespace swarmanoid::mock
